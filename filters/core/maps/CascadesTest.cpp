#include "filters/core/maps/Cascades.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace umbra {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double aspect = 16.0 / 9.0;
// Coordinates up to 100 through matrices of condition 1e4 at most, as in the light's own tests.
constexpr double tolerance = 1e-9;

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution(low, high)(random);
}

// A wide street: its near end at the camera, its far end eighty units off.
const AlignedBox3d street(Vector3d(-40, 0, -40), Vector3d(40, 6, 40));

LightFrame frameOf(LightKind kind) {
  Light light;
  light.kind = kind;
  light.position = kind == LightKind::Spot ? Vector3d(3, 60, 50) : Vector3d(20, 50, 10);
  light.halfAngle = 40.0;
  return fitLightFrame(light, street);
}

Camera walker() {
  Camera camera;
  camera.position = {1.3, 1.7, 38.0};
  camera.target = {0.2, 1.5, 20.0};
  camera.viewAngle = 40.0;
  return camera;
}

MapSettings mapWith(int count, double seam = 0.1) {
  MapSettings map;
  map.cascades.count = count;
  map.cascades.seam = seam;
  return map;
}

void turn(Camera& camera, double degrees) {
  const Eigen::AngleAxisd rotation(degrees * std::numbers::pi / 180.0, camera.up);
  camera.target = camera.position + rotation * (camera.target - camera.position);
}

bool isWhole(double value) {
  return std::abs(value - std::round(value)) < 1e-6;
}

class CascadesOf : public testing::TestWithParam<LightKind> {};

INSTANTIATE_TEST_SUITE_P(Light, CascadesOf,
                         testing::Values(LightKind::Directional, LightKind::Spot),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

TEST(Cascades, AreCutAsTheClosedFormSays) {
  const auto near = [](const std::vector<double>& ends, std::initializer_list<double> expected) {
    ASSERT_EQ(ends.size(), expected.size());
    std::size_t i = 0;
    for (double value : expected) EXPECT_NEAR(ends[i++], value, 1e-12);
  };
  near(practicalSplits(1, 81, 4, 0.0), {1, 21, 41, 61, 81});
  near(practicalSplits(1, 81, 4, 1.0), {1, 3, 9, 27, 81});
  near(practicalSplits(1, 81, 4, 0.5), {1, 12, 25, 44, 81});
  near(practicalSplits(2, 3, 1, 0.5), {2, 3});
  // The ends themselves are not rounded.
  EXPECT_EQ(practicalSplits(0.1, 0.7, 3, 0.3).front(), 0.1);
  EXPECT_EQ(practicalSplits(0.1, 0.7, 3, 0.3).back(), 0.7);
}

TEST_P(CascadesOf, OneCascadeIsTheWholeFrameBitForBit) {
  const LightFrame frame = frameOf(GetParam());
  const std::vector<Cascade> cascades = fitCascades(frame, walker(), aspect, street, mapWith(1), 5);
  ASSERT_EQ(cascades.size(), 1u);
  EXPECT_EQ(cascades[0].left, 0.0);
  EXPECT_EQ(cascades[0].top, 0.0);
  EXPECT_EQ(cascades[0].side, 1.0);
  EXPECT_EQ(cascades[0].frame.worldToLight, frame.worldToLight);
  EXPECT_EQ(cascades[0].frame.lightToClip, frame.lightToClip);
}

TEST_P(CascadesOf, TheyFollowEachOtherThroughTheWholeRange) {
  for (int count = 1; count <= CascadeSettings::largestCount; ++count) {
    const auto cascades =
        fitCascades(frameOf(GetParam()), walker(), aspect, street, mapWith(count));
    ASSERT_EQ(cascades.size(), std::size_t(count));
    EXPECT_EQ(cascades[0].nearDistance, 0.0) << "the camera stands in the street";
    for (std::size_t i = 0; i + 1 < cascades.size(); ++i)
      EXPECT_EQ(cascades[i].farDistance, cascades[i + 1].nearDistance);
    for (const Cascade& cascade : cascades) EXPECT_LT(cascade.nearDistance, cascade.farDistance);
  }
}

// What the camera sees of the street lies in the window of its part, together with its seam and the
// reach of a filter, unless it lies outside the whole map.
TEST_P(CascadesOf, AWindowHoldsItsPartOfTheView) {
  std::mt19937 random(7);
  const LightFrame frame = frameOf(GetParam());
  const double seam = 0.2;
  const int reach = 9;
  int seen = 0, smaller = 0;
  for (int i = 0; i < 60; ++i) {
    Camera camera = walker();
    for (int axis = 0; axis < 3; ++axis) camera.position[axis] += uniform(random, -1.5, 1.5);
    camera.position.z() += i % 3 == 0 ? 30.0 : 0.0;  // the camera stands before the street
    turn(camera, uniform(random, -60.0, 60.0));
    const MapSettings map = mapWith(2 + i % 3, seam);
    const auto cascades = fitCascades(frame, camera, aspect, street, map, reach);
    const Vector3d forward = (camera.target - camera.position).normalized();
    const auto corners = viewCorners(camera, aspect, 0.0, 1.0);  // the far corners are directions
    for (int k = 0; k < 400; ++k) {
      const double x = uniform(random, 0, 1), y = uniform(random, 0, 1),
                   distance = cascades.back().farDistance * std::pow(uniform(random, 0, 1), 2.0);
      const Vector3d ray = corners[4] + x * (corners[5] - corners[4]) +
                           y * (corners[7] - corners[4]) - camera.position;
      const Vector3d point = camera.position + distance * ray;
      ASSERT_NEAR((point - camera.position).dot(forward), distance, tolerance);
      if (!street.contains(point)) continue;
      const LightPoint whole = frame.project(point);
      if (!whole.inside) continue;
      ++seen;
      ASSERT_GE(distance, cascades[0].nearDistance);
      for (std::size_t c = 0; c < cascades.size(); ++c) {
        const double begin = c == 0 ? 0.0 : cascades[c - 1].seamDistance(seam);
        if (distance < begin || distance > cascades[c].farDistance) continue;
        const double margin = cascades[c].side < 1.0 ? double(reach) / map.size : 0.0;
        smaller += cascades[c].side < 0.9;
        const double u = cascades[c].u(whole.u), v = cascades[c].v(whole.v);
        // At the map's own edges there is nothing beyond to be read.
        const bool onEdge = std::min({whole.u, whole.v, 1 - whole.u, 1 - whole.v}) < 0.02;
        const double slack = onEdge ? 0.0 : margin;
        ASSERT_GE(u, slack - tolerance);
        ASSERT_LE(u, 1 - slack + tolerance);
        ASSERT_GE(v, slack - tolerance);
        ASSERT_LE(v, 1 - slack + tolerance);
      }
    }
  }
  EXPECT_GT(seen, 3000);
  EXPECT_GT(smaller, 1000);
}

TEST_P(CascadesOf, ItsFrameProjectsIntoItsWindowAndBack) {
  std::mt19937 random(11);
  const LightFrame frame = frameOf(GetParam());
  const auto cascades = fitCascades(frame, walker(), aspect, street, mapWith(4));
  EXPECT_LT(cascades[0].side, 0.5);
  for (const Cascade& cascade : cascades) {
    EXPECT_EQ(cascade.frame.nearDistance, frame.nearDistance);
    EXPECT_EQ(cascade.frame.farDistance, frame.farDistance);
    for (int i = 0; i < 100; ++i) {
      const Vector3d world =
          frame.unproject(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1));
      const LightPoint whole = frame.project(world), part = cascade.frame.project(world);
      EXPECT_NEAR(part.u, cascade.u(whole.u), tolerance / cascade.side);
      EXPECT_NEAR(part.v, cascade.v(whole.v), tolerance / cascade.side);
      EXPECT_EQ(part.z, whole.z) << "depths of all cascades compare";
      EXPECT_LT((cascade.frame.unproject(part.u, part.v, part.z) - world).norm(), 1e-7);
    }
  }
}

// A texel of a window before a step is a texel of the same place after it.
void expectWholeTexels(const std::vector<Cascade>& before, const std::vector<Cascade>& after,
                       int size) {
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].nearDistance, after[i].nearDistance);
    EXPECT_EQ(before[i].farDistance, after[i].farDistance);
    EXPECT_EQ(before[i].side, after[i].side);
    EXPECT_TRUE(isWhole((after[i].left - before[i].left) / before[i].side * size));
    EXPECT_TRUE(isWhole((after[i].top - before[i].top) / before[i].side * size));
  }
}

TEST(Cascades, OfADirectionalLightMoveByWholeTexelsHoweverTheCameraTurns) {
  const LightFrame frame = frameOf(LightKind::Directional);
  const MapSettings map = mapWith(3);
  const auto start = fitCascades(frame, walker(), aspect, street, map);
  int moved = 0;
  for (double degrees = 0.5; degrees < 360.0; degrees *= 1.5) {
    Camera camera = walker();
    turn(camera, degrees);
    const auto turned = fitCascades(frame, camera, aspect, street, map);
    expectWholeTexels(start, turned, map.size);
    moved += turned[0].left != start[0].left || turned[0].top != start[0].top;
  }
  EXPECT_GT(moved, 5);
}

TEST_P(CascadesOf, MoveByWholeTexelsAsTheCameraWalks) {
  const LightFrame frame = frameOf(GetParam());
  const MapSettings map = mapWith(3);
  const auto start = fitCascades(frame, walker(), aspect, street, map);
  int moved = 0, stood = 0;
  for (int i = 1; i <= 40; ++i) {
    Camera camera = walker();
    const Vector3d step(0.004 * i, 0.001 * i, -0.003 * i);
    camera.position += step;
    camera.target += step;
    const auto walked = fitCascades(frame, camera, aspect, street, map);
    expectWholeTexels(start, walked, map.size);
    (walked[0].left != start[0].left ? moved : stood) += 1;
  }
  EXPECT_GT(moved, 5);
  EXPECT_GT(stood, 0) << "less than a texel moves nothing";
}

TEST(Cascades, TheWindowFollowsTheCamera) {
  const LightFrame frame = frameOf(LightKind::Directional);
  const auto cascades = fitCascades(frame, walker(), aspect, street, mapWith(4));
  for (std::size_t i = 1; i < cascades.size(); ++i)
    EXPECT_GE(cascades[i].side, cascades[i - 1].side) << "what is near gets the most texels";
  EXPECT_EQ(cascades.back().side, 1.0) << "the sphere about the farthest part covers the street";
}

TEST(Cascades, OfASpotBehindWhichTheViewReachesAreTheWholeMap) {
  Light light;
  light.kind = LightKind::Spot;
  light.position = {0, 3, 30};
  light.target = {0, 0, 0};
  const LightFrame frame = fitLightFrame(light, street);
  EXPECT_EQ(fitCascades(frame, walker(), aspect, street, mapWith(3))[0].side, 1.0);
}

}  // namespace
}  // namespace umbra
