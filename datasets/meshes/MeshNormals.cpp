#include "datasets/meshes/MeshNormals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbra {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

// With more faces than this at one vertex, the time to compare each with each would grow with their
// square; only fans and damaged files have so many.
constexpr std::size_t manyFaces = 256;

struct Corner {
  std::uint32_t triangle = 0;
  int corner = 0;
};

struct Faces {
  std::vector<Vector3d> normals;  // unit; zero for a triangle of no area
  std::vector<std::array<double, 3>> angles;
};

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Faces facesOf(std::span<const Eigen::Vector3f> positions, std::span<const Triangle> triangles) {
  Faces faces;
  for (const Triangle& t : triangles) {
    Vector3d p[3];
    for (int i = 0; i < 3; ++i) p[i] = positions[t[i]].cast<double>();
    const Vector3d across = (p[1] - p[0]).cross(p[2] - p[0]);
    const double area = across.norm();
    faces.normals.push_back(area > 0.0 ? Vector3d(across / area) : Vector3d(Vector3d::Zero()));
    std::array<double, 3> angles{};
    for (int i = 0; i < 3; ++i)
      angles[i] = angleBetween(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    faces.angles.push_back(angles);
  }
  return faces;
}

// The mean normal of the faces at a vertex that bend little against `own`.
Vector3d smoothed(const Vector3d& own, std::span<const Corner> around, const Faces& faces,
                  double smallestCosine) {
  if (around.size() > manyFaces) return own;
  Vector3d sum = Vector3d::Zero();
  for (const Corner& other : around) {
    const Vector3d& normal = faces.normals[other.triangle];
    if (normal.dot(own) >= smallestCosine)
      sum += faces.angles[other.triangle][other.corner] * normal;
  }
  return sum.norm() > 0.0 ? Vector3d(sum.normalized()) : own;
}

// The corners of each vertex: those of vertex v are corners[first[v]] up to corners[first[v + 1]].
struct Incidence {
  std::vector<std::uint32_t> first;
  std::vector<Corner> corners;
};

Incidence incidenceOf(std::size_t vertices, std::span<const Triangle> triangles,
                      const Faces& faces) {
  Incidence incidence;
  incidence.first.assign(vertices + 1, 0);
  const auto hasArea = [&](std::size_t t) { return faces.normals[t].squaredNorm() > 0.0; };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (hasArea(t))
      for (std::uint32_t v : triangles[t]) ++incidence.first[v + 1];
  for (std::size_t v = 0; v < vertices; ++v) incidence.first[v + 1] += incidence.first[v];
  incidence.corners.resize(incidence.first.back());
  std::vector<std::uint32_t> next(incidence.first.begin(), incidence.first.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (hasArea(t))
      for (int i = 0; i < 3; ++i)
        incidence.corners[next[triangles[t][i]]++] = {std::uint32_t(t), i};
  return incidence;
}

}  // namespace

Mesh withNormals(std::span<const Eigen::Vector3f> positions, std::span<const Triangle> triangles,
                 double crease, const Progress& progress) {
  const Faces faces = facesOf(positions, triangles);
  const Incidence incidence = incidenceOf(positions.size(), triangles, faces);
  const double smallestCosine = std::cos(crease * std::numbers::pi / 180.0);
  Mesh mesh;
  std::vector<Triangle> welded(triangles.begin(), triangles.end());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    progress.step(v, positions.size());
    const std::span around(incidence.corners.data() + incidence.first[v],
                           incidence.first[v + 1] - incidence.first[v]);
    const std::size_t firstCopy = mesh.positions.size();
    for (const Corner& corner : around) {
      const Eigen::Vector3f normal =
          smoothed(faces.normals[corner.triangle], around, faces, smallestCosine).cast<float>();
      std::size_t copy = around.size() > manyFaces ? mesh.normals.size() : firstCopy;
      while (copy < mesh.normals.size() && mesh.normals[copy].dot(normal) < 1.0f - 1e-6f) ++copy;
      if (copy == mesh.normals.size()) {
        mesh.positions.push_back(positions[v]);
        mesh.normals.push_back(normal.normalized());
      }
      welded[corner.triangle][corner.corner] = std::uint32_t(copy);
    }
  }
  for (std::size_t t = 0; t < welded.size(); ++t)
    if (faces.normals[t].squaredNorm() > 0.0) mesh.triangles.push_back(welded[t]);
  return mesh;
}

}  // namespace umbra
