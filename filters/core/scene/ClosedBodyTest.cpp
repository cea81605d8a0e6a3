// Which meshes may be drawn without their back faces.
#include "filters/core/scene/ClosedBody.h"

#include <gtest/gtest.h>

#include <utility>

namespace umbra {
namespace {

// A tetrahedron with a corner at `origin` and a vertex of its own for every corner of a face, as
// flat shading needs them.
Mesh tetrahedron(const Eigen::Vector3f& origin = Eigen::Vector3f::Zero()) {
  const Eigen::Vector3f corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Mesh mesh;
  for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (int corner : {a, b, c}) mesh.positions.push_back(origin + corners[corner]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

void turnInsideOut(Mesh& mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

Mesh both(Mesh a, const Mesh& b) {
  const auto offset = std::uint32_t(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& [i, j, k] : b.triangles)
    a.triangles.push_back({i + offset, j + offset, k + offset});
  return a;
}

TEST(ClosedBody, IsClosedWhereEveryEdgeIsShared) {
  EXPECT_TRUE(isClosedBody(tetrahedron()));
  EXPECT_TRUE(isClosedBody(both(tetrahedron(), tetrahedron({5, 0, 0}))));
}

TEST(ClosedBody, IsOpenWhereAFaceIsMissing) {
  Mesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  EXPECT_FALSE(isClosedBody(mesh));
}

TEST(ClosedBody, IsOpenWhereOneFaceIsTurnedRound) {
  Mesh mesh = tetrahedron();
  std::swap(mesh.triangles[2][0], mesh.triangles[2][1]);
  EXPECT_FALSE(isClosedBody(mesh));
}

TEST(ClosedBody, IsNoBodyInsideOut) {
  Mesh inverted = tetrahedron();
  turnInsideOut(inverted);
  EXPECT_FALSE(isClosedBody(inverted));
  // Nor does a larger or equal part the right way round make up for it.
  EXPECT_FALSE(isClosedBody(both(tetrahedron({5, 0, 0}), inverted)));
}

TEST(ClosedBody, PartsAreToldApart) {
  Mesh open = tetrahedron({5, 0, 0});
  open.triangles.pop_back();
  const std::vector<bool> expected{true, true, true, true, false, false, false};
  EXPECT_EQ(closedTriangles(both(tetrahedron(), open)), expected);
}

}  // namespace
}  // namespace umbra
