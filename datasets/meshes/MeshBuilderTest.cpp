// The shapes of the scenes, and the normals that they and mesh files without any get.
#include "datasets/scenes/MeshBuilder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "datasets/meshes/MeshNormals.h"

namespace umbra::scenes {
namespace {

constexpr double pi = std::numbers::pi;
using Triangle = std::array<std::uint32_t, 3>;

// The volume by the divergence theorem; it is positive when the faces are counter-clockwise from
// outside.
double volumeOf(const Mesh& mesh) {
  double volume = 0.0;
  for (const Triangle& t : mesh.triangles)
    volume += mesh.positions[t[0]].cast<double>().dot(
                  mesh.positions[t[1]].cast<double>().cross(mesh.positions[t[2]].cast<double>())) /
              6.0;
  return volume;
}

// Whether every edge is walked once in each direction. Vertices at the same place count as one.
bool isClosed(const Mesh& mesh) {
  using Place = std::array<float, 3>;
  std::map<std::pair<Place, Place>, int> edges;
  const auto place = [&](std::uint32_t v) {
    const Eigen::Vector3f& p = mesh.positions[v];
    return Place{p.x(), p.y(), p.z()};
  };
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const Place from = place(t[i]), to = place(t[(i + 1) % 3]);
      if (from == to) return false;
      ++edges[{from, to}];
    }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return true;
}

// Vertex normals are unit and on the same side as the faces that use them.
void expectSoundNormals(const Mesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (const Eigen::Vector3f& normal : mesh.normals) EXPECT_NEAR(normal.norm(), 1.0f, 1e-5f);
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3f face = (mesh.positions[t[1]] - mesh.positions[t[0]])
                                     .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
    EXPECT_GT(face.norm(), 0.0f);
    for (std::uint32_t v : t) EXPECT_GT(mesh.normals[v].dot(face), 0.0f);
  }
}

struct Body {
  std::string name;
  Mesh mesh;
  double volume;  // the faceted body's volume
};

// Area of the regular polygon of n corners in a circle of radius 1.
double polygon(int n) {
  return 0.5 * n * std::sin(2.0 * pi / n);
}

std::vector<Body> bodies() {
  const std::vector<Vector2d> notched{{0, 0}, {3, 0}, {3, 2}, {2, 2},
                                      {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const std::vector<Vector2d> vase{{0, 0}, {1, 0}, {1, 2}, {0.5, 2}, {0, 3}};
  const std::vector<Vector3d> straight{{0, 0, 0}, {0, 1, 0}, {0, 3, 0}};
  const std::vector<double> radii{0.5, 0.5, 0.5};
  return {{"box", box({-1, 0, 2}, {1, 3, 3}), 6.0},
          {"board", board({4, 5, 6}, {1, 2, 3}, 37.0, {1, 2, 3}), 6.0},
          {"extruded", extruded(notched, -1.0, 1.0), 10.0},
          {"cylinder", cylinder({1, 0, 0}, {1, 2, 2}, 0.5, 0.5, 24),
           0.25 * polygon(24) * std::sqrt(8.0)},
          {"cone", cylinder({0, 0, 0}, {3, 0, 0}, 1.0, 0.0, 16), polygon(16)},
          {"lathe", lathe(vase, 32), polygon(32) * (2.0 + 0.25 / 3.0)},
          {"tube", tube(straight, radii, 12), 0.25 * polygon(12) * 3.0}};
}

TEST(MeshBuilder, MakesClosedBodiesOfTheRightVolumeFacingOutwards) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    EXPECT_TRUE(isClosed(body.mesh));
    // Positions are floats of magnitude up to 8.
    EXPECT_NEAR(volumeOf(body.mesh), body.volume, 2e-5 * body.volume);
    expectSoundNormals(body.mesh);
  }
}

TEST(MeshBuilder, RoundBodiesNearTheirSmoothVolume) {
  const Mesh ball = sphere({1, 2, 3}, 1.5, 64);
  EXPECT_TRUE(isClosed(ball));
  expectSoundNormals(ball);
  const double exact = 4.0 / 3.0 * pi * 1.5 * 1.5 * 1.5;
  EXPECT_LT(volumeOf(ball), exact);
  EXPECT_GT(volumeOf(ball), 0.99 * exact);
  const Mesh ring = torus({0, 1, 0}, {1, 1, 0}, 2.0, 0.3, 64, 24);
  EXPECT_TRUE(isClosed(ring));
  expectSoundNormals(ring);
  EXPECT_NEAR(volumeOf(ring), 2.0 * polygon(24) * 0.09 * pi * 2.0, 0.01 * volumeOf(ring));
}

TEST(MeshBuilder, ASphereIsSmoothAndItsNormalsAreRadial) {
  const Mesh ball = sphere({0, 0, 0}, 2.0, 48);
  // One vertex for every place: 24 rows less the poles, 48 to a row, and the two poles.
  EXPECT_EQ(ball.positions.size(), 23u * 48u + 2u);
  for (std::size_t i = 0; i < ball.positions.size(); ++i)
    EXPECT_GT(ball.normals[i].dot(ball.positions[i].normalized()), 0.999f);
}

TEST(MeshBuilder, ABoxHasSharpEdges) {
  const Mesh cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(cube.positions.size(), 24u);
  EXPECT_EQ(cube.triangles.size(), 12u);
  for (const Eigen::Vector3f& normal : cube.normals) EXPECT_EQ(normal.cwiseAbs().maxCoeff(), 1.0f);
}

TEST(MeshBuilder, MovesAndTurnsNormalsWithTheirBody) {
  const Mesh cube = transformed(box({-1, -1, -1}, {1, 1, 1}), moved({5, 0, 0}) * turned(30.0));
  EXPECT_NEAR((cube.bounds().center() - Vector3d(5, 0, 0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(volumeOf(cube), 8.0, 1e-4);
  expectSoundNormals(cube);
}

TEST(MeshBuilder, RandomNumbersAreTheSameEverywhere) {
  Random random(1);
  // SplitMix64's first outputs for seed 1, as published with the generator.
  EXPECT_EQ(random.uniform(), double(0x910a2dec89025cc1u >> 11) * 0x1p-53);
  EXPECT_EQ(random.uniform(), double(0xbeeb8da1658eec67u >> 11) * 0x1p-53);
  Vector3d sum = Vector3d::Zero();
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const Vector3d direction = random.direction();
    EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
    sum += direction;
  }
  // Each component has variance ⅓: six standard deviations of the mean.
  EXPECT_LT((sum / count).cwiseAbs().maxCoeff(), 6.0 * std::sqrt(1.0 / 3.0 / count));
}

TEST(MeshNormals, BreakOnlyAtEdgesSharperThanTheCrease) {
  // Two triangles that share an edge, the second bent out of the first's plane.
  for (double bend : {20.0, 60.0}) {
    const double angle = bend * pi / 180.0;
    const std::vector<Eigen::Vector3f> points{
        {0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {float(std::cos(angle)), 0, float(std::sin(angle))}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {1, 0, 3}};
    const Mesh mesh = withNormals(points, triangles, 40.0);
    EXPECT_EQ(mesh.positions.size(), bend < 40.0 ? 4u : 6u) << bend;
  }
}

TEST(MeshNormals, WeighFacesByAngleSoThatTheCutOfAQuadDoesNotShow) {
  // At (0,0,0) one wall is one triangle, the other is cut in two there.
  const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  const Mesh mesh = withNormals(points, triangles, 120.0);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].norm() > 0.0f) continue;
    const Eigen::Vector3f expected = Eigen::Vector3f(1, 1, 1).normalized();
    EXPECT_NEAR((mesh.normals[i] - expected).norm(), 0.0f, 1e-6f);
  }
}

TEST(MeshNormals, LeaveOutTrianglesWithoutArea) {
  const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 0, 3}, {0, 1, 3}};
  const Mesh mesh = withNormals(points, triangles);
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.normals[0], Eigen::Vector3f(0, 0, 1));
}

// A fan around one vertex, as in a damaged or flat-capped file: it has more faces than are
// compared.
TEST(MeshNormals, HandleAVertexWithThousandsOfFaces) {
  const std::uint32_t count = 20000;
  std::vector<Eigen::Vector3f> points{{0, 0, 0}};
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2.0 * pi * i / count;
    points.emplace_back(float(std::cos(angle)), float(std::sin(angle)), 0.0f);
    triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  const Mesh mesh = withNormals(points, triangles);
  EXPECT_EQ(mesh.triangles.size(), count);
  for (const Eigen::Vector3f& normal : mesh.normals) EXPECT_NEAR(normal.z(), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace umbra::scenes
