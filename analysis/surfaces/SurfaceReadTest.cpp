#include "analysis/surfaces/SurfaceRead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/surfaces/SurfaceSpot.h"

namespace umbra {
namespace {

using Eigen::Vector3d;

const Eigen::AlignedBox3d readRoom(Vector3d(-2, -1, -2), Vector3d(2, 3, 2));
const Vector3d readPoint(0.3, 0.4, -0.2);
const Vector3d tilted = Vector3d(0.3, 1.0, -0.2).normalized();

struct Setting {
  explicit Setting(LightKind kind, const Vector3d& position = {1, 9, 2}) {
    Light light;
    light.kind = kind;
    light.position = position;
    frame = fitLightFrame(light, readRoom);
    camera.position = {0.5, 6.0, 5.0};
    camera.target = readPoint;
    settings.map.size = 512;
  }
  std::variant<SurfacePoint, Unreadable> read(const Vector3d& normal, bool twoSided = false) {
    cascades = fitCascades(frame, camera, 4.0 / 3.0, readRoom, settings.map);
    return readOfSurface(
        {readPoint, normal, 0, twoSided},
        {{camera, 640, 480}, frame, cascades, settings, readRoom.diagonal().norm()});
  }

  LightFrame frame;
  Camera camera;
  FrameSettings settings;
  std::vector<Cascade> cascades;
};

// How much the plane's depth changes from texel to texel, along u and v together, by rays through
// the map half of `step` texels to either side.
double depthGain(const LightFrame& frame, const Vector3d& normal, int size, double step) {
  const LightPoint at = frame.project(readPoint);
  const auto depth = [&](double du, double dv) {
    const double u = at.u + du / size, v = at.v + dv / size;
    const Vector3d from = frame.unproject(u, v, 0.0), way = frame.unproject(u, v, 1.0) - from;
    return frame.project(from + way * (normal.dot(readPoint - from) / normal.dot(way))).z;
  };
  const double half = 0.5 * step;
  return (std::abs(depth(half, 0) - depth(-half, 0)) + std::abs(depth(0, half) - depth(0, -half))) /
         step;
}

TEST(SurfaceRead, TheReceiverIsLoweredByThePlanesOwnSlope) {
  for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
    Setting setting(kind);
    setting.settings.kernel = {KernelShape::Box, 3};
    setting.settings.bias = {1e-3, 1.5, true, false};
    const auto read = std::get<SurfacePoint>(setting.read(tilted));
    const LightPoint at = setting.frame.project(readPoint);
    // A bilinear read reaches a texel beyond the kernel. Half the difference over two texels errs
    // by the third derivative, a part of (1/512)² of the gain; over a hundredth by its rounding,
    // 1e-11.
    const double gain = depthGain(setting.frame, tilted, 512, 0.01);
    EXPECT_GT(gain, 1e-5);
    EXPECT_NEAR(read.receiver, at.z - 1e-3 - (1.5 + 3.0 + 1.0) * gain, 1e-10);
    EXPECT_NEAR(read.u, at.u, 1e-12);
    EXPECT_NEAR(read.v, at.v, 1e-12);
    EXPECT_TRUE(read.facesLight);
    EXPECT_FALSE(std::get<SurfacePoint>(setting.read(-tilted)).facesLight);
    // A sheet has no inside: the visible side counts whichever way its triangle runs.
    EXPECT_TRUE(std::get<SurfacePoint>(setting.read(tilted, true)).facesLight);
    EXPECT_TRUE(std::get<SurfacePoint>(setting.read(-tilted, true)).facesLight);
    setting.settings.bias = {0.0, 0.0, false, false};
    EXPECT_NEAR(std::get<SurfacePoint>(setting.read(tilted)).receiver, at.z, 1e-12);
  }
}

TEST(SurfaceRead, APlaneSeenEdgeOnIsLoweredByATenth) {
  Setting setting(LightKind::Directional, {0, 9, 1e-3});
  setting.settings.bias = {0.0, 1.0, false, false};
  const auto read = std::get<SurfacePoint>(setting.read(Vector3d::UnitX()));
  EXPECT_NEAR(read.receiver, setting.frame.project(readPoint).z - 0.1, 1e-12);
}

// Light and camera are straight above a level plane: a pixel is a square of the map.
TEST(SurfaceRead, AFootprintIsWhatThePixelCovers) {
  Setting setting(LightKind::Directional, {1e-6, 9, 0});
  setting.settings.read.filter = ReadFilter::Trilinear;
  setting.camera.position = readPoint + Vector3d(0, 40, 1e-6);
  const auto read = std::get<SurfacePoint>(setting.read(Vector3d::UnitY()));
  const double pixel = 40.0 * 2.0 * std::tan(15.0 * std::numbers::pi / 180.0) / 480;
  const double texel =
      (setting.frame.unproject(0.5 + 1.0 / 512, 0.5, 0.5) - setting.frame.unproject(0.5, 0.5, 0.5))
          .norm();
  EXPECT_GT(pixel / texel, 2.0);
  // Both views are turned against the axes by a millionth and less.
  EXPECT_NEAR(std::hypot(read.footprint.x, read.footprint.y), pixel / texel, 1e-4);
  EXPECT_EQ(read.footprint.probes, 1);

  setting.settings.read.filter = ReadFilter::SummedArea;
  setting.settings.kernel = {KernelShape::Box, 1};
  setting.settings.read.satSize = SatSize::Distance;
  setting.settings.read.satDistance = 100.0;
  const auto box = std::get<SurfacePoint>(setting.read(Vector3d::UnitY()));
  EXPECT_NEAR(box.footprint.x, 3.0 * 100.0 / 40.0, 1e-9);
  setting.settings.read.satSize = SatSize::Fixed;
  EXPECT_EQ(std::get<SurfacePoint>(setting.read(Vector3d::UnitY())).footprint.y, 3.0);
}

TEST(SurfaceRead, WhatCannotBeReadSaysWhy) {
  Setting behind(LightKind::Directional);
  behind.camera.target =
      2.0 * behind.camera.position - readPoint;  // the camera looks away from the point
  EXPECT_TRUE(
      std::holds_alternative<SurfacePoint>(behind.read(tilted)));  // a plain read needs no camera
  for (ReadFilter filter :
       {ReadFilter::Trilinear, ReadFilter::Anisotropic, ReadFilter::SummedArea}) {
    behind.settings.read.filter = filter;
    EXPECT_EQ(std::get<Unreadable>(behind.read(tilted)), Unreadable::NotInSight);
  }
  Setting away(LightKind::Spot);
  away.frame.worldToLight.topRightCorner<3, 1>() += Vector3d(50, 0, 0);
  EXPECT_EQ(std::get<Unreadable>(away.read(tilted)), Unreadable::OutsideMap);
}

// Before the end of a cascade it alone is read, in the seam the next one as well, and behind it the
// next alone. Points that a window does not hold are left to the next cascade.
TEST(SurfaceRead, CascadesFollowTheDistanceFromTheCamera) {
  Setting setting(LightKind::Directional);
  setting.settings.map.cascades.count = 3;
  setting.settings.map.cascades.seam = 0.2;
  const double own = (readPoint - setting.camera.position).norm();  // the camera looks at the point
  const auto readWith = [&](double firstEnd, double side) {
    std::vector<Cascade> cascades(3);
    for (Cascade& cascade : cascades) cascade.frame = setting.frame;
    cascades[0].side = side;
    cascades[0].farDistance = firstEnd;
    cascades[1].nearDistance = firstEnd;
    cascades[1].farDistance = 10.0 * own;
    cascades[2].nearDistance = 10.0 * own;
    cascades[2].farDistance = 20.0 * own;
    return std::get<SurfacePoint>(readOfSurface(
        {readPoint, tilted},
        {{setting.camera, 640, 480}, setting.frame, cascades, setting.settings, 1.0}));
  };
  const auto expect = [](const SurfacePoint& read, int cascade, double next) {
    EXPECT_EQ(read.cascade, cascade);
    EXPECT_NEAR(read.nextCascade, next, 1e-9);
  };
  expect(readWith(own / 0.7, 1.0), 0, 0.0);
  expect(readWith(own / 0.9, 1.0), 0, 0.5);  // in the middle of the last fifth
  expect(readWith(own * 0.9, 1.0), 1, 0.0);
  expect(readWith(own / 0.7, 1e-3), 1, 0.0);
}

TEST(PictureView, ARayThroughAPointsPixelPassesThePoint) {
  const Setting setting(LightKind::Directional);
  const PictureView view{setting.camera, 640, 480};
  const Vector3d other(1.0, 0.2, 1.0);
  const auto pixel = view.pixelOf(other);
  ASSERT_TRUE(pixel);
  const Vector3d ray = view.rayThrough(*pixel), way = other - setting.camera.position;
  EXPECT_LT(ray.cross(way).norm(), 1e-12 * ray.norm() * way.norm() * 10);
  EXPECT_NEAR((*view.pixelOf(readPoint) - Eigen::Vector2d(320, 240)).norm(), 0.0, 1e-9);
  EXPECT_FALSE(view.pixelOf(2.0 * setting.camera.position - readPoint));
}

TEST(PictureView, WhatStandsInFrontIsNotThePoint) {
  const Setting setting(LightKind::Directional);
  const PictureView view{setting.camera, 640, 480};
  const Vector3d way = (setting.camera.position - readPoint).normalized();
  EXPECT_TRUE(isSeenAt(view, readPoint, tilted, readPoint));
  EXPECT_FALSE(isSeenAt(view, readPoint, tilted, readPoint + 0.2 * way));
  const Vector3d along = way.cross(tilted).normalized();  // in the plane, across the view
  const double pixel = (readPoint - setting.camera.position).norm() * 2.0 *
                       std::tan(15.0 * std::numbers::pi / 180.0) / 480;
  EXPECT_TRUE(isSeenAt(view, readPoint, tilted, readPoint + 0.7 * pixel * along));
  EXPECT_FALSE(isShownAt(view, readPoint, readPoint + 0.1 * pixel * along));
  EXPECT_TRUE(isShownAt(view, readPoint, readPoint + 0.001 * pixel * along));
}

TEST(SurfaceSpot, TheNearestTriangleAndItsObjectAreFound) {
  const auto triangle = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                           const Eigen::Vector3f& c) {
    SceneObject object;
    object.mesh.positions = {a, b, c};
    object.mesh.triangles = {{0, 1, 2}};
    return object;
  };
  Scene scene;
  scene.objects = {triangle({0, 0, 0}, {0, 0, 4}, {4, 0, 0}),
                   triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0})};
  const auto level = surfaceNear(scene, {1, 0, 1}), upright = surfaceNear(scene, {1, 1, 0});
  ASSERT_TRUE(level && upright);
  EXPECT_EQ(level->object, 0u);
  EXPECT_EQ(upright->object, 1u);
  EXPECT_TRUE(level->twoSided);
  EXPECT_EQ(level->normal, Vector3d::UnitY());
  EXPECT_EQ(upright->normal, Vector3d::UnitZ());
  EXPECT_FALSE(surfaceNear(scene, {3, 0, 3}));     // in the plane, beside the triangle
  EXPECT_FALSE(surfaceNear(scene, {1, -0.1, 1}));  // under it
}

}  // namespace
}  // namespace umbra
