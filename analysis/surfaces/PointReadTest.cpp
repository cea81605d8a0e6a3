#include "analysis/surfaces/PointRead.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

using Eigen::Vector3d;

const Eigen::AlignedBox3d pointRoom(Vector3d(-2, -1, -2), Vector3d(2, 3, 2));
const Vector3d pinned(0.3, 0.0, -0.2);
const SurfaceSpot pinnedSpot{pinned, Vector3d::UnitY(), 0, false};

struct PointFrame {
  PointFrame() {
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {1, 9, 2};
    light = fitLightFrame(sun, pointRoom);
    picture.camera.position = {0.5, 6.0, 5.0};
    picture.camera.target = pinned;
    settings.map.size = 512;
    cascades = fitCascades(light, picture.camera, 641.0 / 481.0, pointRoom, settings.map);
  }

  // In the point's pixel the picture shows `shown`, at this place in the world.
  std::optional<SeenPoint> seen(const Vector3d& world) const {
    SurfacePoint surface = shown;
    surface.world = world;
    return seenPoint(pinned, pinnedSpot, picture, [&](int x, int y) {
      EXPECT_EQ(x, 320);
      EXPECT_EQ(y, 240);
      return std::optional(surface);
    });
  }
  std::variant<PointRead, NotRead> read(const std::optional<SeenPoint>& seen) const {
    return readOfPoint(pinned, pinnedSpot,
                       {picture, light, cascades, settings, pointRoom.diagonal().norm()}, seen);
  }

  PictureView picture{{}, 641, 481};  // the point is in the middle of a pixel
  LightFrame light;
  FrameSettings settings;
  std::vector<Cascade> cascades;
  SurfacePoint shown{.u = 0.5, .v = 0.5, .receiver = 0.75, .visibility = 0.25};
};

TEST(PointRead, ThePixelThatShowsTheVeryPointIsRead) {
  const PointFrame frame;
  const auto seen = frame.seen(pinned);
  ASSERT_TRUE(seen);
  EXPECT_TRUE(seen->isPoint);
  const auto read = std::get<PointRead>(frame.read(seen));
  EXPECT_TRUE(read.asShown);
  ASSERT_TRUE(read.seen);
  EXPECT_EQ(read.surface.receiver, 0.75);
  EXPECT_EQ(read.surface.visibility, 0.25);
}

TEST(PointRead, BesideTheMiddleOfAPixelThePointItselfIsRead) {
  const PointFrame frame;
  const auto seen = frame.seen(pinned + Vector3d(0.003, 0.0, 0.0));  // a third of a pixel
  ASSERT_TRUE(seen);
  EXPECT_FALSE(seen->isPoint);
  const auto read = std::get<PointRead>(frame.read(seen));
  EXPECT_FALSE(read.asShown);
  EXPECT_TRUE(read.seen) << "in sight all the same";
  EXPECT_EQ(read.surface.world, pinned);
  EXPECT_NEAR(read.surface.u, frame.light.project(pinned).u, 1e-12);
}

TEST(PointRead, BehindSomethingThePointIsHiddenAndRead) {
  const PointFrame frame;
  const Vector3d way = (frame.picture.camera.position - pinned).normalized();
  const auto seen = frame.seen(pinned + way);
  EXPECT_FALSE(seen);
  const auto read = std::get<PointRead>(frame.read(seen));
  EXPECT_FALSE(read.seen);
  EXPECT_FALSE(read.asShown);
}

TEST(PointRead, OutOfThePictureNothingIsAskedOfIt) {
  PointFrame frame;
  frame.picture.camera.target = 2.0 * frame.picture.camera.position - pinned;  // looks away
  EXPECT_FALSE(
      seenPoint(pinned, pinnedSpot, frame.picture, [](int, int) -> std::optional<SurfacePoint> {
        ADD_FAILURE() << "there is no pixel";
        return std::nullopt;
      }));
}

// A point on the map's edge: the pixel beside it may show what is just outside.
TEST(PointRead, APixelOutsideTheMapIsInSightButNotRead) {
  PointFrame frame;
  frame.shown.v = 1.5;
  const auto seen = frame.seen(pinned);
  ASSERT_TRUE(seen);
  EXPECT_FALSE(seen->isPoint);
  const auto read = std::get<PointRead>(frame.read(seen));
  EXPECT_TRUE(read.seen);
  EXPECT_FALSE(read.asShown);
}

TEST(PointRead, SaysWhyAPointIsNotRead) {
  PointFrame frame;
  EXPECT_EQ(std::get<NotRead>(readOfPoint(
                pinned, std::nullopt,
                {frame.picture, frame.light, frame.cascades, frame.settings, 1.0}, std::nullopt)),
            NotRead::NoSurface);
  const Vector3d far(900.0, 0.0, 0.0);
  EXPECT_EQ(std::get<NotRead>(readOfPoint(
                far, SurfaceSpot{far, Vector3d::UnitY(), 0, false},
                {frame.picture, frame.light, frame.cascades, frame.settings, 1.0}, std::nullopt)),
            NotRead::OutsideMap);
  frame.settings.read.filter = ReadFilter::Anisotropic;
  frame.picture.camera.target = 2.0 * frame.picture.camera.position - pinned;
  EXPECT_EQ(std::get<NotRead>(frame.read(std::nullopt)), NotRead::NotInSight);
}

}  // namespace
}  // namespace umbra
