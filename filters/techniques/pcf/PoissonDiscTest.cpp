#include "filters/techniques/pcf/PoissonDisc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "filters/techniques/pcf/Pcf.h"

namespace umbra {
namespace {

pcf::Pcf discOf(int taps) {
  pcf::Pcf technique;
  technique.values = {.taps = pcf::Taps::Poisson, .poissonTaps = taps};
  return technique;
}

double visibilityOf(const pcf::Pcf& technique, const Region& region, double receiver) {
  return technique.visibility({{}, region}, receiver);
}

// n discs of radius d/2 about points that are d apart lie inside a disc of radius 1 + d/2 without
// overlap: n (d/2)² < (1 + d/2)². Half of the d that this allows is a good cover.
TEST(PoissonDisc, EveryBeginningOfThePointsKeepsItsDistance) {
  double nearest = 2.0;
  for (int n = 1; n < pcf::largestTapCount; ++n) {
    const auto [x, y] = pcf::discPoints[n];
    EXPECT_LT(x * x + y * y, 1024 * 1024);
    for (int i = 0; i < n; ++i)
      nearest = std::min(nearest,
                         std::hypot(x - pcf::discPoints[i].x, y - pcf::discPoints[i].y) / 1024.0);
    const double allowed = 2.0 / (std::sqrt(n + 1.0) - 1.0);
    EXPECT_GT(nearest, 0.5 * std::min(allowed, 1.0)) << n + 1 << " points";
  }
}

TEST(PoissonDisc, OffsetsStayWithinReachAndUseIt) {
  for (int reach : {0, 1, 3, 64, 127}) {
    int widest = 0;
    for (int turn = 0; turn < 500; ++turn) {
      for (int tap = 0; tap < pcf::largestTapCount; ++tap) {
        const auto [x, y] = pcf::tapOffset(tap, turn, 7 * turn, reach, reach / 2);
        ASSERT_LE(std::abs(x), reach);
        ASSERT_LE(std::abs(y), reach / 2);
        widest = std::max(widest, std::abs(x));
      }
    }
    EXPECT_GE(widest, reach * 9 / 10);
  }
}

TEST(PoissonDisc, TurnsFromTexelToTexel) {
  int alike = 0;
  for (int x = 0; x < 1024; ++x) alike += pcf::rotationOf(x, 5) == pcf::rotationOf(x + 1, 5);
  // Among 1024 neighbours one in 64 is alike by chance: 16, with a standard deviation of 4.
  EXPECT_LT(alike, 16 + 5 * 4);
  EXPECT_EQ(pcf::rotationOf(17, 4), pcf::rotationOf(17, 4));
}

// An edge through the middle: half of any turned disc, but for the points that the edge cuts.
TEST(PoissonDisc, FindsTheShareOfAHalfPlane) {
  DepthMap map(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) map(x, y) = x < 32 ? 0.25 : 0.75;
  const Kernel kernel{KernelShape::Box, 8};
  double mean = 0.0;
  int count = 0;
  for (int y = 8; y < 56; ++y) {
    const Region region = regionAtTexel(map, kernel, 31, y);
    const double visibility = visibilityOf(discOf(64), region, 0.5);
    EXPECT_NEAR(visibility, referenceVisibility(region, 0.5), 0.15);
    mean += visibility;
    ++count;
  }
  // Half of the disc less the column of its middle, which blocks: 1/17 of the box, and at most
  // 4/π of that of the disc.
  const double middle = 4.0 / 3.14159 / 17.0;
  EXPECT_LT(mean / count, 0.5);
  EXPECT_GT(mean / count, 0.5 - middle);
}

TEST(PoissonDisc, AgreesWhereAllTexelsDo) {
  const DepthMap map(9, 9, 1, 0.5);
  const Region region = regionAtTexel(map, {KernelShape::Gaussian, 3}, 0, 8);  // a corner
  for (int taps : {4, 16, 64}) {
    EXPECT_EQ(visibilityOf(discOf(taps), region, 0.5), 1.0);
    EXPECT_EQ(visibilityOf(discOf(taps), region, 0.6), 0.0);
  }
}

// A texel of two samples, one of which blocks, counts half.
TEST(PoissonDisc, ComparesEverySampleOfATexel) {
  DepthMap map(5, 5, 2);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) map(x, y, 0) = 0.2, map(x, y, 1) = 0.8;
  EXPECT_EQ(visibilityOf(discOf(16), regionAtTexel(map, {KernelShape::Box, 1}, 2, 2), 0.5), 0.5);
}

TEST(PoissonDisc, SaysThatItSamples) {
  DepthMap map(32, 32, 1, 1.0);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) map(x, y) = (x / 3 + y / 2) % 2 ? 0.3 : 0.9;
  const pcf::Pcf technique = discOf(4);
  int sampled = 0;
  for (int x = 8; x < 24; ++x) {
    const Region region = regionAtTexel(map, {KernelShape::Box, 6}, x, 16);
    const Trace trace = technique.explain({{}, region}, 0.6);
    EXPECT_EQ(trace.steps.back().value, visibilityOf(technique, region, 0.6));
    sampled += trace.cause == ErrorCause::Sampling;
  }
  EXPECT_GT(sampled, 0);
}

}  // namespace
}  // namespace umbra
