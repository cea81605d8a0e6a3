#include "filters/core/scene/Light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "filters/core/scene/Scene.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

double evenly(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution(low, high)(random);
}

Vector3d pointIn(const AlignedBox3d& box, std::mt19937& random) {
  Vector3d point;
  for (int i = 0; i < 3; ++i) point[i] = evenly(random, box.min()[i], box.max()[i]);
  return point;
}

AlignedBox3d someBox(std::mt19937& random) {
  const AlignedBox3d around(Vector3d(-5, -5, -5), Vector3d(5, 5, 5));
  AlignedBox3d box(pointIn(around, random));
  return box.extend(pointIn(around, random));
}

Light someLight(LightKind kind, std::mt19937& random) {
  Light light;
  light.kind = kind;
  do {
    for (int i = 0; i < 3; ++i) light.position[i] = evenly(random, -20.0, 20.0);
    for (int i = 0; i < 3; ++i) light.target[i] = evenly(random, -2.0, 2.0);
  } while ((light.position - light.target).norm() < 1.0);
  light.halfAngle = evenly(random, 5.0, 60.0);
  return light;
}

std::vector<Vector3d> cornersOf(const AlignedBox3d& box) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(box.corner(AlignedBox3d::CornerType(i)));
  return corners;
}

// The matrices invert with a condition of about (40 / 0.05)²; twelve of double's sixteen digits
// are left of coordinates up to 40.
constexpr double coordinateTolerance = 1e-9;

class EveryLight : public testing::TestWithParam<LightKind> {};

TEST_P(EveryLight, ProjectsAndUnprojectsToTheSamePlace) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const LightFrame frame = fitLightFrame(someLight(GetParam(), random), someBox(random));
    const double u = evenly(random, 0.0, 1.0), v = evenly(random, 0.0, 1.0),
                 z = evenly(random, 0.0, 1.0);
    const LightPoint back = frame.project(frame.unproject(u, v, z));
    EXPECT_TRUE(back.inside);
    EXPECT_NEAR(back.u, u, coordinateTolerance);
    EXPECT_NEAR(back.v, v, coordinateTolerance);
    EXPECT_NEAR(back.z, z, coordinateTolerance);
  }
}

TEST_P(EveryLight, KeepsTheBoxBetweenNearAndFar) {
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    const Light light = someLight(GetParam(), random);
    const AlignedBox3d box = someBox(random);
    // Inside the box a spot light sees what is nearer than any near plane.
    if (GetParam() == LightKind::Spot && box.exteriorDistance(light.position) < 0.1) continue;
    const LightFrame frame = fitLightFrame(light, box);
    for (const Vector3d& corner : cornersOf(box)) {
      EXPECT_GT(frame.project(corner).z, 0.0);
      EXPECT_LT(frame.project(corner).z, 1.0);
    }
    for (int k = 0; k < 20; ++k) {
      const LightPoint point = frame.project(pointIn(box, random));
      EXPECT_GT(point.z, 0.0);
      EXPECT_LT(point.z, 1.0);
    }
  }
}

// Depth is linear in distance: half-way between near and far plane it is a half.
TEST_P(EveryLight, MeasuresDepthLinearly) {
  std::mt19937 random(9);
  for (int i = 0; i < 100; ++i) {
    const LightFrame frame = fitLightFrame(someLight(GetParam(), random), someBox(random));
    for (double z : {0.0, 0.25, 0.5, 1.0}) {
      const Vector3d point = frame.unproject(0.3, 0.8, z);
      const double expected = frame.nearDistance + z * (frame.farDistance - frame.nearDistance);
      EXPECT_NEAR(frame.distance(point), expected, coordinateTolerance);
    }
  }
}

// Row 0 is the top: what lies towards the light's upward side has the smaller v.
TEST_P(EveryLight, HasVDownAndUToTheRight) {
  Light light;
  light.kind = GetParam();
  light.position = {0.0, 0.0, 10.0};  // looks along −z, so that up is +y and right is +x
  const LightFrame frame =
      fitLightFrame(light, AlignedBox3d(Vector3d(-1, -1, -1), Vector3d(1, 1, 1)));
  const LightPoint centre = frame.project(Vector3d::Zero());
  EXPECT_NEAR(centre.u, 0.5, 1e-12);
  EXPECT_NEAR(centre.v, 0.5, 1e-12);
  EXPECT_LT(frame.project({0.0, 0.5, 0.0}).v, 0.5);
  EXPECT_GT(frame.project({0.5, 0.0, 0.0}).u, 0.5);
  // The matrix for the rasteriser agrees: clip y = −1 is the top row.
  const Eigen::Vector4d clip = frame.worldToClip() * Vector3d(0.0, 0.5, 0.0).homogeneous();
  EXPECT_NEAR(0.5 + 0.5 * clip.y() / clip.w(), frame.project({0.0, 0.5, 0.0}).v, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Light, EveryLight,
                         testing::Values(LightKind::Directional, LightKind::Spot),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

TEST(Light, ADirectionalFrameHoldsEveryCornerOfTheBoxTightly) {
  std::mt19937 random(13);
  for (int i = 0; i < 300; ++i) {
    const AlignedBox3d box = someBox(random);
    const LightFrame frame = fitLightFrame(someLight(LightKind::Directional, random), box);
    double lowU = 1, highU = 0, lowV = 1, highV = 0, lowZ = 1, highZ = 0;
    for (const Vector3d& corner : cornersOf(box)) {
      const LightPoint point = frame.project(corner);
      EXPECT_TRUE(point.inside);
      lowU = std::min(lowU, point.u), highU = std::max(highU, point.u);
      lowV = std::min(lowV, point.v), highV = std::max(highV, point.v);
      lowZ = std::min(lowZ, point.z), highZ = std::max(highZ, point.z);
    }
    // The longer side fills the square but for its margin of 1 %; depth has a margin of 2 % at
    // either end.
    EXPECT_NEAR(std::max(highU - lowU, highV - lowV), 1.0 / 1.01, coordinateTolerance);
    EXPECT_NEAR(lowZ, 0.02 / 1.04, coordinateTolerance);
    EXPECT_NEAR(highZ, 1.02 / 1.04, coordinateTolerance);
  }
}

TEST(Light, ASpotsMapTouchesItsCone) {
  Light light;
  light.kind = LightKind::Spot;
  light.position = {0.0, 0.0, 10.0};
  const AlignedBox3d box(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
  for (double degrees : {10.0, 30.0, 60.0}) {
    light.halfAngle = degrees;
    const double edge = 10.0 * std::tan(degrees * std::numbers::pi / 180.0);
    const LightFrame frame = fitLightFrame(light, box);
    EXPECT_NEAR(frame.project({edge, 0.0, 0.0}).u, 1.0, 1e-12);
    EXPECT_NEAR(frame.project({0.0, edge, 0.0}).v, 0.0, 1e-12);
    EXPECT_FALSE(frame.project({0.0, 0.0, 12.0}).inside) << "behind the light";
  }
}

// The rasteriser's planes must not cut off what lies between the near and the far distance.
TEST(Light, ASpotsClipVolumeHoldsEveryDepthOfTheMap) {
  std::mt19937 random(17);
  for (int i = 0; i < 100; ++i) {
    const LightFrame frame = fitLightFrame(someLight(LightKind::Spot, random), someBox(random));
    for (double u : {0.0, 0.5, 1.0})
      for (double z : {1e-6, 0.5, 1.0}) {
        const Eigen::Vector4d clip = frame.worldToClip() * frame.unproject(u, u, z).homogeneous();
        EXPECT_LE(std::abs(clip.z()), clip.w() * (1.0 + 1e-9));
      }
  }
}

TEST(Light, RefusesNoDirectionAndNoScene) {
  Light light;
  light.position = light.target;
  const AlignedBox3d box(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
  EXPECT_THROW(fitLightFrame(light, box), Error);
  EXPECT_THROW(fitLightFrame(Light{}, AlignedBox3d()), Error);
}

// The message of the error that validation throws, or "" where it throws none.
template <class T>
std::string faultOf(const T& value) {
  try {
    validate(value, "s.json: x");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
    return error.what();
  }
  return "";
}

TEST(Light, IsValidatedWhole) {
  EXPECT_EQ(faultOf(Light{}), "");
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(faultOf(Light{.position = {1, 2, 3}, .target = {1, 2, 3}}),
            "s.json: x: position and target are the same point, they should differ");
  EXPECT_EQ(faultOf(Light{.position = {0, infinite, 0}}),
            "s.json: x: the position is inf, it should be from -1e+09 to 1e+09");
  EXPECT_EQ(faultOf(Light{.halfAngle = 60.1}),
            "s.json: x: the half angle is 60.1, it should be from 1 to 60");
  EXPECT_EQ(faultOf(Light{.colour = {1, -0.5, 1}}),
            "s.json: x: the colour is -0.5, it should be from 0 to 1");
  EXPECT_EQ(faultOf(Light{.intensity = -1}),
            "s.json: x: the intensity is -1, it should be from 0 to 1000");
  EXPECT_NE(faultOf(Light{.intensity = std::nan("")}), "");
}

TEST(Camera, IsValidatedWhole) {
  EXPECT_EQ(faultOf(Camera{}), "");
  EXPECT_EQ(faultOf(Camera{.position = {1, 2, 3}, .target = {1, 2, 3}}),
            "s.json: x: position and target are the same point, they should differ");
  EXPECT_EQ(faultOf(Camera{.up = {0, 0, 0}}),
            "s.json: x: the up vector has no length, it should point up");
  EXPECT_EQ(faultOf(Camera{.position = {0, 5, 0}, .up = {0, -2, 0}}),
            "s.json: x: the up vector lies along the view, it should point to its side");
  EXPECT_EQ(faultOf(Camera{.viewAngle = 170}),
            "s.json: x: the view angle is 170, it should be from 1 to 120");
  EXPECT_NE(faultOf(Camera{.up = {0, std::nan(""), 0}}), "");
}

}  // namespace
}  // namespace umbra
