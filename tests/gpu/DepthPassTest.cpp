// The depth pass against rays that are intersected here.
#include <cmath>

#include "tests/gpu/FrameFixture.h"
#include "tests/gpu/Rounding.h"

namespace umbra {
namespace {

using DepthPass = test::FrameFixture;

// Distance along the ray of map point (u, v) to the nearest of the slab's six faces and the
// ground, as depth; 1 where the ray meets nothing.
double castRay(const LightFrame& frame, double u, double v) {
  const Eigen::Vector3d near = frame.unproject(u, v, 0.0), far = frame.unproject(u, v, 1.0);
  const Eigen::Vector3d along = far - near;
  double nearest = 1.0;
  const auto plane = [&](int axis, double at, const Eigen::Vector3d& low,
                         const Eigen::Vector3d& high) {
    const double t = (at - near[axis]) / along[axis];
    const Eigen::Vector3d hit = near + t * along;
    for (int other = 0; other < 3; ++other)
      if (other != axis && (hit[other] < low[other] || hit[other] > high[other])) return;
    if (t > 0.0 && t < nearest) nearest = t;
  };
  plane(1, 0.0, {-5, 0, -5}, {5, 0, 5});
  const Eigen::Vector3d low(1, 1, -2), high(3, 1.2, -1);
  for (int axis = 0; axis < 3; ++axis)
    for (double at : {low[axis], high[axis]}) plane(axis, at, low, high);
  return nearest;
}

// A texel next to an edge may fall on either side of it: its neighbours' rays tell.
bool nearEdge(const LightFrame& frame, int size, int x, int y) {
  const double centre = castRay(frame, (x + 0.5) / size, (y + 0.5) / size);
  for (double dy : {-0.01, 0.01})
    for (double dx : {-0.01, 0.01})
      if (std::abs(castRay(frame, (x + 0.5 + dx) / size, (y + 0.5 + dy) / size) - centre) > 1e-3)
        return true;
  return false;
}

TEST_F(DepthPass, AgreesWithRaysOfEveryKindOfLight) {
  settings.map.size = 96;
  for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
    for (const Eigen::Vector3d& position : {Eigen::Vector3d(0, 8, 0), Eigen::Vector3d(4, 7, 2)}) {
      SCOPED_TRACE(std::string(nameOf(kind)) + " from " + std::to_string(position.x()));
      const auto scene = test::slabOverGround();
      scene->light.kind = kind;
      scene->light.position = position;
      scene->light.halfAngle = 55;
      show(scene, "hard");
      const DepthMap& map = renderer->depthMap();
      const LightFrame frame = renderer->lightFrame();
      // World coordinates up to 12 go through a matrix product, an interpolation over the
      // triangle and a length: sixteen roundings of that size, in units of the depth range.
      const double tolerance = 16 * test::eps * 12.0 / (frame.farDistance - frame.nearDistance);
      int compared = 0;
      for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
          if (nearEdge(frame, map.width(), x, y)) continue;
          ++compared;
          ASSERT_NEAR(map(x, y), castRay(frame, (x + 0.5) / map.width(), (y + 0.5) / map.height()),
                      tolerance)
              << "texel " << x << "," << y;
        }
      }
      EXPECT_GT(compared, 96 * 96 * 9 / 10);
    }
  }
}

TEST_F(DepthPass, FrontFacesCanBeCulled) {
  settings.bias.cullFrontFaces = true;
  const auto scene = test::slabOverGround();
  show(scene, "hard");
  const LightFrame frame = renderer->lightFrame();
  const auto depthUnder = [&](const Eigen::Vector3d& world) {
    const LightPoint point = frame.project(world);
    const DepthMap& map = renderer->depthMap();
    return map(int(point.u * map.width()), int(point.v * map.height()));
  };
  // The slab's underside and nothing of the ground, which has but one side.
  EXPECT_NEAR(depthUnder({2, 1, -1.5}), frame.project({2, 1, -1.5}).z, 1e-6);
  EXPECT_EQ(depthUnder({-2, 0, 2}), 1.0);
  settings.bias.cullFrontFaces = false;
  showAgain();
  EXPECT_NEAR(depthUnder({2, 1, -1.5}), frame.project({2, 1.2, -1.5}).z, 1e-6);
}

// An object that does not bound the light's frame may reach beyond its near plane.
TEST_F(DepthPass, WhatLiesBeforeTheNearPlaneStillCasts) {
  const auto scene = test::slabOverGround();
  SceneObject roof;
  roof.mesh = test::box({-4, 6, 2}, {-2, 6.1f, 4});
  roof.boundsLight = false;
  scene->objects.push_back(roof);
  show(scene, "hard");
  const LightPoint point = renderer->lightFrame().project({-3, 6.1, 3});
  ASSERT_LT(point.z, 0.0);
  const DepthMap& map = renderer->depthMap();
  EXPECT_EQ(map(int(point.u * map.width()), int(point.v * map.height())), 0.0);
}

}  // namespace
}  // namespace umbra
