#include "analysis/surfaces/SurfaceMesh.h"

#include "analysis/surfaces/SurfaceDivider.h"
#include "filters/core/scene/ClosedBody.h"

namespace umbra {
namespace {

using Eigen::Vector3d;

bool hasArea(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3d a = mesh.positions[triangle[0]].cast<double>();
  const Vector3d b = mesh.positions[triangle[1]].cast<double>();
  const Vector3d c = mesh.positions[triangle[2]].cast<double>();
  return (b - a).cross(c - a).norm() > 0.0;
}

SurfaceMesh trianglesOf(const Scene& scene) {
  SurfaceMesh result;
  for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
    const Mesh& mesh = scene.objects[object].mesh;
    const auto offset = std::uint32_t(result.positions.size());
    result.positions.insert(result.positions.end(), mesh.positions.begin(), mesh.positions.end());
    result.normals.insert(result.normals.end(), mesh.normals.begin(), mesh.normals.end());
    const std::vector<bool> closed = closedTriangles(mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto [a, b, c] = mesh.triangles[i];
      if (hasArea(mesh, mesh.triangles[i]))
        result.faces.push_back({{a + offset, b + offset, c + offset}, object, !closed[i]});
    }
  }
  return result;
}

}  // namespace

double cosineToLight(const LightFrame& light, const Vector3d& world, const Vector3d& normal) {
  const Vector3d way =
      light.kind == LightKind::Spot ? Vector3d(light.position - world) : Vector3d(-light.direction);
  const double length = way.norm() * normal.norm();
  return length > 0.0 ? way.dot(normal) / length : 0.0;
}

SurfaceMesh surfaceMeshOf(const Scene& scene, const LightFrame& light, int mapSize,
                          const SurfaceMeshSettings& settings, const std::function<void()>& check) {
  SurfaceMesh mesh = trianglesOf(scene);
  check();
  SurfaceDivider divider(mesh, light, mapSize);
  const std::size_t most = mesh.faces.size() + settings.mostFaces;
  // Edges are divided from coarse to fine, so that detail for which there is no room is missing
  // evenly.
  double edge = settings.edge;
  while (edge < mapSize) edge *= 2.0;
  for (mesh.edge = divider.longestEdge(); edge >= settings.edge; edge *= 0.5) {
    if (!divider.divide(edge, most, check)) break;
    mesh.edge = edge;
  }
  return mesh;
}

}  // namespace umbra
