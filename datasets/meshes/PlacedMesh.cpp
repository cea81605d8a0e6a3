// How a part of a mesh file becomes a mesh of floats.
#include "datasets/meshes/MeshFileReader.h"
#include "datasets/meshes/MeshNormals.h"
#include "filters/core/scene/Weld.h"

namespace umbra::meshfile {
namespace {

// The vertices that triangles use, in the order of their first use.
struct Used {
  std::vector<std::uint32_t> vertices;
  std::vector<Triangle> triangles;  // of places in `vertices`
};

Used usedOf(std::size_t positions, std::span<const Triangle> triangles) {
  Used used;
  used.triangles.reserve(triangles.size());
  std::vector<std::uint32_t> place(positions, UINT32_MAX);
  for (const Triangle& t : triangles) {
    Triangle& moved = used.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& to = place[t[i]];
      if (to == UINT32_MAX) {
        to = std::uint32_t(used.vertices.size());
        used.vertices.push_back(t[i]);
      }
      moved[i] = to;
    }
  }
  return used;
}

// Lets triangles share what are equal positions.
void weld(std::vector<Eigen::Vector3f>& positions, std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> place = firstOfEqual(positions);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const bool isFirst = place[v] == v;
    if (isFirst) positions[kept] = positions[v];
    place[v] = isFirst ? std::uint32_t(kept++) : place[place[v]];
  }
  positions.resize(kept);
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) v = place[v];
}

}  // namespace

Mesh placedMesh(const RawMesh& raw, std::span<const Triangle> triangles,
                const Eigen::Affine3d& placement, const Progress& progress) {
  progress.tell(0.0);
  Used used = usedOf(raw.positions.size(), triangles);
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(used.vertices.size());
  for (std::uint32_t v : used.vertices)
    positions.push_back((placement * raw.positions[v]).cast<float>());
  if (raw.normals.empty()) {
    weld(positions, used.triangles);
    return withNormals(positions, used.triangles, usualCrease, progress.stage(0.3, 1.0));
  }
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(used.triangles);
  const Eigen::Matrix3d turn = placement.linear().inverse().transpose();
  for (std::uint32_t v : used.vertices)
    mesh.normals.push_back((turn * raw.normals[v].cast<double>()).normalized().cast<float>());
  return mesh;
}

}  // namespace umbra::meshfile
