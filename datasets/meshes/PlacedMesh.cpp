// How a part of a mesh file becomes a mesh of floats.
#include <bit>
#include <unordered_map>

#include "datasets/meshes/MeshFileReader.h"
#include "datasets/meshes/MeshNormals.h"

namespace umbra::meshfile {
namespace {

struct PositionHash {
  std::size_t operator()(const std::array<std::uint32_t, 3>& bits) const {
    std::uint64_t hash = 0;
    for (std::uint32_t b : bits) hash = (hash ^ b) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29;
    return std::size_t(hash);
  }
};

std::array<std::uint32_t, 3> bitsOf(const Eigen::Vector3f& p) {
  // Adding 0 makes +0 of −0, which is equal to it.
  return {std::bit_cast<std::uint32_t>(p.x() + 0.0f), std::bit_cast<std::uint32_t>(p.y() + 0.0f),
          std::bit_cast<std::uint32_t>(p.z() + 0.0f)};
}

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
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, PositionHash> first;
  first.reserve(positions.size());
  std::vector<std::uint32_t> place(positions.size());
  std::size_t kept = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto [found, isNew] = first.try_emplace(bitsOf(positions[v]), std::uint32_t(kept));
    if (isNew) positions[kept++] = positions[v];
    place[v] = found->second;
  }
  positions.resize(kept);
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) v = place[v];
}

}  // namespace

Mesh placedMesh(const RawMesh& raw, std::span<const Triangle> triangles,
                const Eigen::Affine3d& placement) {
  Used used = usedOf(raw.positions.size(), triangles);
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(used.vertices.size());
  for (std::uint32_t v : used.vertices)
    positions.push_back((placement * raw.positions[v]).cast<float>());
  if (raw.normals.empty()) {
    weld(positions, used.triangles);
    return withNormals(positions, used.triangles);
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
