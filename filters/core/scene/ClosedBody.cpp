#include "filters/core/scene/ClosedBody.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "filters/core/scene/Weld.h"

namespace umbra {
namespace {

// The connected part that a corner belongs to, named by its representative. Paths are halved on the
// way.
std::uint32_t partOf(std::vector<std::uint32_t>& parents, std::uint32_t corner) {
  while (parents[corner] != corner) corner = parents[corner] = parents[parents[corner]];
  return corner;
}

}  // namespace

std::vector<bool> closedTriangles(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = firstOfEqual(mesh.positions);
  std::vector<std::uint32_t> parents(welded.size());
  std::iota(parents.begin(), parents.end(), 0u);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = welded[triangle[i]], to = welded[triangle[(i + 1) % 3]];
      edges.emplace_back(from, to);
      parents[partOf(parents, from)] = partOf(parents, to);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<bool> open(welded.size(), false);  // indexed by a part's representative
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [from, to] = edges[i];
    const bool twice = i + 1 < edges.size() && edges[i + 1] == edges[i];
    if (twice || !std::binary_search(edges.begin(), edges.end(), std::pair(to, from)))
      open[partOf(parents, from)] = true;
  }
  std::vector<double> volumes(welded.size(), 0.0);  // six times the volume of each part
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d p = mesh.positions[a].cast<double>();
    const Eigen::Vector3d q = mesh.positions[b].cast<double>();
    const Eigen::Vector3d r = mesh.positions[c].cast<double>();
    volumes[partOf(parents, welded[a])] += p.dot(q.cross(r));
  }
  std::vector<bool> closed;
  for (const auto& triangle : mesh.triangles) {
    const std::uint32_t part = partOf(parents, welded[triangle[0]]);
    closed.push_back(!open[part] && volumes[part] > 0.0);
  }
  return closed;
}

bool isClosedBody(const Mesh& mesh) {
  const std::vector<bool> closed = closedTriangles(mesh);
  return std::find(closed.begin(), closed.end(), false) == closed.end();
}

}  // namespace umbra
