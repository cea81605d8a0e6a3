#include "analysis/rays/RayTracedVisibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace umbra {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// A rectangle at height y, turned about the vertical, seen from above by its front.
SceneObject plate(const Vector3f& middle, float halfX, float halfZ, float angle = 0.0f) {
  const Vector3f x = halfX * Vector3f(std::cos(angle), 0.0f, std::sin(angle));
  const Vector3f z = halfZ * Vector3f(-std::sin(angle), 0.0f, std::cos(angle));
  SceneObject object;
  object.mesh.positions = {middle - x - z, middle - x + z, middle + x + z, middle + x - z};
  object.mesh.normals.assign(4, Vector3f::UnitY());
  object.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return object;
}

SceneObject turnedOver(SceneObject object) {
  for (auto& triangle : object.mesh.triangles) std::swap(triangle[1], triangle[2]);
  return object;
}

Light lightAbove(LightKind kind = LightKind::Directional) {
  Light light;
  light.kind = kind;
  light.position = {0.0, 10.0, 0.0};
  light.target = {0.0, 0.0, 0.0};
  light.halfAngle = 30.0;
  return light;
}

Scene sceneOf(std::vector<SceneObject> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.light = lightAbove();
  return scene;
}

Cascade wholeFrame(const Scene& scene, const Light& light) {
  Cascade cascade;
  cascade.frame = fitLightFrame(light, scene.lightBounds());
  return cascade;
}

// A ray's origin and its hit are rounded to single precision several times each.
double depthTolerance(const LightFrame& frame, double rayLength) {
  return 16.0 * std::numeric_limits<float>::epsilon() * rayLength /
         (frame.farDistance - frame.nearDistance);
}

DepthMap anyMap(int size) {
  return DepthMap(size, size, 1, 0.5);
}

double halfReach(LightKind kind) {
  return kind == LightKind::Spot ? 1.5 : 4.0;
}

// The closed form: an edge along an axis cuts a tap's square where it cuts it.
TEST(RayTracedVisibility, SlabCoversWhatItCovers) {
  constexpr int size = 64, side = 4;
  const Scene scene = sceneOf({plate({0, 0, 0}, 5, 5), plate({0.37f, 2, 0}, 1.03f, 5)});
  const Light light = lightAbove();
  const Cascade whole = wholeFrame(scene, light);
  const RayTracedVisibility rays(scene, {&whole, 1}, size, false, side);
  const LightPoint a = whole.frame.project({0.37 - 1.03f, 2, 0});
  const LightPoint b = whole.frame.project({0.37 + 1.03f, 2, 0});
  const bool alongU = std::abs(a.u - b.u) > std::abs(a.v - b.v);
  const auto ends = std::minmax({size * (alongU ? a.u : a.v), size * (alongU ? b.u : b.v)});
  const double receiver = whole.frame.project({0, 1, 0}).z;  // a receiver between both
  const Kernel kernel{KernelShape::Box, 3};
  const DepthMap map = anyMap(size);
  int penumbra = 0;
  for (int i = 8; i < size - 8; ++i) {
    const Region region = regionAtTexel(map, kernel, alongU ? i : 32, alongU ? 32 : i);
    const double covered =
        std::max(0.0, std::min(i + 4.0, ends.second) - std::max(i - 3.0, ends.first));
    const double expected = 1.0 - covered / 7.0;
    penumbra += expected > 0.0 && expected < 1.0;
    // Either edge is off by half a row of the rays of one texel in seven at most.
    EXPECT_NEAR(rays(region, receiver), expected, 2.0 * 0.5 / (side * side) / 7.0 + 1e-12) << i;
  }
  EXPECT_GE(penumbra, 7);
}

// A plate turned by an angle, so that its edges cross texels in many ways.
struct TurnedPlate {
  static constexpr int size = 32, fine = 16;
  static constexpr float angle = 0.4f;
  Scene scene = sceneOf({plate({0, 0, 0}, 5, 5), plate({0.3f, 2, 0.1f}, 1.7f, 1.1f, angle)});
  Cascade whole = wholeFrame(scene, lightAbove());
  double top = whole.frame.project({0, 2, 0}).z, ground = whole.frame.project({0, 0, 0}).z;

  bool lit(double u, double v) const {
    const Vector3d world = whole.frame.unproject(u, v, top);
    const double dx = world.x() - 0.3f, dz = world.z() - 0.1f;
    return std::abs(std::cos(angle) * dx + std::sin(angle) * dz) > 1.7f ||
           std::abs(-std::sin(angle) * dx + std::cos(angle) * dz) > 1.1f;
  }
  // Judges the 5 × 5 texels about (x, y) by 16 × 16 places of each.
  double exact(int x, int y) const {
    int count = 0;
    for (int j = 0; j < 5 * fine; ++j)
      for (int i = 0; i < 5 * fine; ++i)
        count += lit((x - 2 + (i + 0.5) / fine) / size, (y - 2 + (j + 0.5) / fine) / size);
    return count / (25.0 * fine * fine);
  }
};

TEST(RayTracedVisibility, ComesToPercentageCloserFilteringOfALargeMap) {
  const TurnedPlate turned;
  const DepthMap map = anyMap(turned.size);
  double last = 1.0;
  for (const int side : {1, 2, 4, 8}) {
    const RayTracedVisibility rays(turned.scene, {&turned.whole, 1}, turned.size, false, side);
    double sum = 0.0;
    int penumbra = 0;
    for (int y = 4; y < turned.size - 4; ++y)
      for (int x = 4; x < turned.size - 4; ++x) {
        const double exact = turned.exact(x, y);
        const double traced = rays(regionAtTexel(map, {KernelShape::Box, 2}, x, y),
                                   0.5 * (turned.top + turned.ground));
        if (exact == 0.0 || exact == 1.0) continue;
        ++penumbra;
        sum += std::abs(traced - exact);
        // Two straight edges at most cross 2·5·side cells of rays each, and 2·5·fine of the
        // places: of these, shares of the region, all may be wrong.
        EXPECT_LE(std::abs(traced - exact), 4.0 / (5.0 * side) + 4.0 / (5.0 * turned.fine));
      }
    ASSERT_GT(penumbra, 30);
    EXPECT_LT(sum / penumbra, last) << side;
    last = sum / penumbra;
  }
}

TEST(RayTracedVisibility, EmptySceneIsLit) {
  const Scene scene = sceneOf({plate({0, 0, 0}, 5, 5)});
  const Cascade whole = wholeFrame(scene, lightAbove());
  const Scene empty;
  const RayTracedVisibility rays(empty, {&whole, 1}, 64, false, 2);
  const DepthMap map = anyMap(64);
  // 25 taps of weight 1/25.
  EXPECT_DOUBLE_EQ(rays(regionAtTexel(map, {KernelShape::Box, 2}, 30, 30), 1.0), 1.0);
}

TEST(RayTracedVisibility, EdgeTexelsRepeat) {
  constexpr int size = 40;
  const Scene scene = sceneOf({plate({0, 0, 0}, 5, 5)});
  const Cascade whole = wholeFrame(scene, lightAbove());
  const RayTracedVisibility rays(scene, {&whole, 1}, size, false, 3);
  const DepthMap map = anyMap(size);
  // The ground ends half a percent before the map's edge: a part of the edge texel sees nothing.
  const Region region = regionAtTexel(map, {KernelShape::Box, 8}, 0, 20);
  const Region edge = regionAtTexel(map, {KernelShape::None}, 0, 20);
  const Region next = regionAtTexel(map, {KernelShape::None}, 4, 20);
  EXPECT_GT(rays(edge, 1.0), 0.0);
  EXPECT_EQ(rays(next, 1.0), 0.0);
  // Nine of the 17 columns are the edge texel's.
  EXPECT_NEAR(rays(region, 1.0), 9.0 / 17.0 * rays(edge, 1.0), 1e-12);
}

TEST(RayTracedVisibility, SamplesStandForTheirTexel) {
  const Scene scene = sceneOf({plate({0, 0, 0}, 5, 5), plate({0.37f, 2, 0}, 1.03f, 5)});
  const Cascade whole = wholeFrame(scene, lightAbove());
  const RayTracedVisibility rays(scene, {&whole, 1}, 64, false, 2);
  const DepthMap one = anyMap(64), four(64, 64, 4, 0.5);
  const Kernel kernel{KernelShape::Gaussian, 4};
  const double receiver = whole.frame.project({0, 1, 0}).z;
  for (int x = 20; x < 44; ++x)
    EXPECT_NEAR(rays(regionAtTexel(one, kernel, x, 32), receiver),
                rays(regionAtTexel(four, kernel, x, 32), receiver), 1e-12);
}

TEST(RayTracedVisibility, FewerRaysForMoreTexels) {
  EXPECT_EQ(RayTracedVisibility::sideFor(1024, 1), 8);
  EXPECT_EQ(RayTracedVisibility::sideFor(1024, 4), 4);
  EXPECT_EQ(RayTracedVisibility::sideFor(8192, 4), 1);
}

class CasterRaysOf : public testing::TestWithParam<LightKind> {};

TEST_P(CasterRaysOf, DepthIsThatOfThePlane) {
  const double reach = halfReach(GetParam());
  const Scene scene = sceneOf({plate({0, 0, 0}, 5, 5)});
  const LightFrame frame = fitLightFrame(lightAbove(GetParam()), scene.bounds());
  const CasterRays casters(scene, false);
  const LightRays rays = casters.raysOf(frame);
  for (double x = -reach; x <= reach; x += 0.37)
    for (double z = -reach; z <= reach; z += 0.41) {
      const LightPoint point = frame.project({x, 0.0, z});
      ASSERT_TRUE(point.inside);
      EXPECT_NEAR(casters.depth(rays, point.u, point.v), point.z, depthTolerance(frame, 20.0));
    }
}

// Rays through the very vertices and edges that triangles share.
TEST_P(CasterRaysOf, NoneSlipsBetweenTriangles) {
  Scene scene = sceneOf({});
  SceneObject grid;
  constexpr int count = 17;
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i)
      grid.mesh.positions.push_back(
          {0.625f * float(i - 8), 0.1f * float((i * 7 + j * 3) % 5), 0.625f * float(j - 8)});
  for (unsigned j = 0; j + 1 < count; ++j)
    for (unsigned i = 0; i + 1 < count; ++i) {
      const unsigned a = j * count + i, b = a + 1, c = a + count, d = c + 1;
      grid.mesh.triangles.push_back({a, c, d});
      grid.mesh.triangles.push_back({a, d, b});
    }
  scene.objects.push_back(grid);
  const LightFrame frame = fitLightFrame(lightAbove(GetParam()), scene.bounds());
  const CasterRays casters(scene, false);
  const LightRays rays = casters.raysOf(frame);
  const double reach = halfReach(GetParam());
  int tried = 0;
  const auto expectHit = [&](const Vector3d& world) {
    if (std::abs(world.x()) > reach || std::abs(world.z()) > reach) return;
    const LightPoint point = frame.project(world);
    EXPECT_LT(casters.depth(rays, point.u, point.v), 1.0) << world.transpose();
    ++tried;
  };
  for (const auto& [a, b, c] : grid.mesh.triangles)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      for (double t = 0.0; t < 1.0; t += 0.125) {
        const Vector3d start = grid.mesh.positions[from].cast<double>();
        expectHit(start + t * (grid.mesh.positions[to].cast<double>() - start));
      }
  EXPECT_GT(tried, 500);
}

TEST_P(CasterRaysOf, FrontFacesLeaveNoDepthWhenCulled) {
  const Scene scene =
      sceneOf({plate({0, 0, 0}, 5, 5), plate({0, 3, 0}, 1, 1), turnedOver(plate({0, 2, 0}, 1, 1))});
  const LightFrame frame = fitLightFrame(lightAbove(GetParam()), scene.bounds());
  const auto depth = [&](bool cull) {
    const CasterRays casters(scene, cull);
    return casters.depth(casters.raysOf(frame), 0.5, 0.5);
  };
  const double tolerance = depthTolerance(frame, 20.0);
  EXPECT_NEAR(depth(false), frame.project({0, 3, 0}).z, tolerance);
  EXPECT_NEAR(depth(true), frame.project({0, 2, 0}).z, tolerance);
}

TEST_P(CasterRaysOf, WhatIsBeforeTheNearPlaneHasDepthZero) {
  const Scene low = sceneOf({plate({0, 0, 0}, 5, 5), plate({0, 1, 0}, 1, 1)});
  const LightFrame frame = fitLightFrame(lightAbove(GetParam()), low.bounds());
  Scene high = low;
  high.objects.push_back(plate({0, 5, 0}, 0.5f, 0.5f));
  const CasterRays casters(high, false);
  const LightRays rays = casters.raysOf(frame);
  EXPECT_EQ(casters.depth(rays, 0.5, 0.5), 0.0);
  const LightPoint beside = frame.project({1.4, 0, 0});
  EXPECT_NEAR(casters.depth(rays, beside.u, beside.v), beside.z, depthTolerance(frame, 20.0));
}

INSTANTIATE_TEST_SUITE_P(Lights, CasterRaysOf,
                         testing::Values(LightKind::Directional, LightKind::Spot),
                         [](const auto& light) { return std::string(nameOf(light.param)); });

}  // namespace
}  // namespace umbra
