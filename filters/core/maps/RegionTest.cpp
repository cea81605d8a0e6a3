#include "filters/core/maps/Region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

DepthMap noise(int width, int height) {
  DepthMap map(width, height);
  std::mt19937 random(31);
  for (double& depth : map.values()) depth = std::uniform_real_distribution(0.0, 1.0)(random);
  return map;
}

double totalWeight(const Region& region) {
  double sum = 0.0;
  for (const RegionTexel& texel : region.texels) sum += texel.weight;
  return sum;
}

// The weight of every pixel of the map in the region.
std::map<std::pair<int, int>, double> weightsByPixel(const Region& region) {
  std::map<std::pair<int, int>, double> weights;
  for (const RegionTexel& texel : region.texels) weights[{texel.x, texel.y}] += texel.weight;
  return weights;
}

TEST(Region, HoldsTheTapsOfItsKernelRowByRow) {
  const DepthMap map = noise(9, 9);
  const Region region = regionAtTexel(map, {KernelShape::Box, 1}, 4, 6);
  ASSERT_EQ(region.texels.size(), 9u);
  std::size_t i = 0;
  for (int y = 5; y <= 7; ++y) {
    for (int x = 3; x <= 5; ++x, ++i) {
      EXPECT_EQ(region.texels[i].x, x);
      EXPECT_EQ(region.texels[i].y, y);
      EXPECT_EQ(region.texels[i].depth, map(x, y));
      EXPECT_NEAR(region.texels[i].weight, 1.0 / 9.0, 1e-16);
    }
  }
  EXPECT_EQ(region.nearestDepth, map(4, 6));
}

TEST(Region, RepeatsTheEdgeBeyondTheBorder) {
  const DepthMap map = noise(5, 4);
  const Region region = regionAtTexel(map, {KernelShape::Box, 1}, 0, 3);
  const auto weights = weightsByPixel(region);
  ASSERT_EQ(weights.size(), 4u);
  EXPECT_NEAR(weights.at({0, 3}), 4.0 / 9.0, 1e-15);
  EXPECT_NEAR(weights.at({1, 3}), 2.0 / 9.0, 1e-15);
  EXPECT_NEAR(weights.at({0, 2}), 2.0 / 9.0, 1e-15);
  EXPECT_NEAR(weights.at({1, 2}), 1.0 / 9.0, 1e-15);
}

TEST(Region, MayBeLargerThanTheMap) {
  const DepthMap map = noise(2, 3);
  const Region region = regionAtTexel(map, {KernelShape::Gaussian, 10}, 1, 1);
  EXPECT_EQ(region.texels.size(), 441u);
  EXPECT_NEAR(totalWeight(region), 1.0, 1e-13);
}

TEST(Region, RefusesATexelOutsideTheMap) {
  const DepthMap map = noise(5, 4);
  for (const auto& [x, y] :
       {std::pair(-1, 0), std::pair(5, 0), std::pair(0, -1), std::pair(0, 4)}) {
    try {
      regionAtTexel(map, {}, x, y);
      ADD_FAILURE() << x << "," << y << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadCommandLine);
      EXPECT_NE(std::string(error.what()).find(std::to_string(x) + "," + std::to_string(y)),
                std::string::npos);
    }
  }
}

TEST(BilinearRegion, IsTheFourNeighboursMixed) {
  const DepthMap map = noise(12, 10);
  const Kernel kernel{KernelShape::Gaussian, 2};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 40; ++trial) {
    const double u = uniform(random), v = uniform(random);
    const double px = u * 12 - 0.5, py = v * 10 - 0.5;
    const double fx = px - std::floor(px), fy = py - std::floor(py);
    std::map<std::pair<int, int>, double> expected;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        // Beyond the border the map's edge is repeated, not the prefiltered map's: here both fall
        // on the same weights only inside, so stay there.
        const int x = int(std::floor(px)) + i, y = int(std::floor(py)) + j;
        if (x < 0 || y < 0 || x >= 12 || y >= 10) continue;
        const double weight = (i ? fx : 1 - fx) * (j ? fy : 1 - fy);
        for (const auto& [pixel, w] : weightsByPixel(regionAtTexel(map, kernel, x, y)))
          expected[pixel] += weight * w;
      }
    }
    const Region region = regionBilinear(map, kernel, u, v);
    EXPECT_EQ(region.texels.size(), 36u);
    EXPECT_NEAR(totalWeight(region), 1.0, 1e-14);
    if (px < 0 || py < 0 || px > 11 || py > 9) continue;
    for (const auto& [pixel, weight] : weightsByPixel(region))
      EXPECT_NEAR(weight, expected[pixel], 1e-15) << u << " " << v;
  }
}

TEST(BilinearRegion, KnowsTheTexelNearestToTheRead) {
  const DepthMap map = noise(4, 4);
  const auto nearest = [&](double u, double v) {
    const Region region = regionBilinear(map, {KernelShape::None, 0}, u, v);
    EXPECT_EQ(region.nearestDepth, map(region.x, region.y));
    return std::pair(region.x, region.y);
  };
  EXPECT_EQ(nearest(0.0, 0.0), std::pair(0, 0));
  EXPECT_EQ(nearest(0.26, 0.74), std::pair(1, 2));
  EXPECT_EQ(nearest(1.0, 1.0), std::pair(3, 3));
}

Region regionOf(std::vector<std::pair<double, double>> depthsAndWeights) {
  Region region;
  for (const auto& [depth, weight] : depthsAndWeights)
    region.texels.push_back({0, 0, depth, weight});
  return region;
}

TEST(RegionStatistics, FollowTheirDefinitions) {
  const RegionStatistics s = statisticsOf(regionOf({{0.25, 0.5}, {0.5, 0.25}, {1.0, 0.25}}));
  EXPECT_EQ(s.mean, 0.5);
  EXPECT_EQ(s.secondMoment, 0.5 * 0.0625 + 0.25 * 0.25 + 0.25);
  EXPECT_EQ(s.variance, s.secondMoment - 0.25);
  EXPECT_EQ(s.min, 0.25);
  EXPECT_EQ(s.max, 1.0);
  EXPECT_EQ(s.beta, 0.5);
}

TEST(RegionStatistics, OfOneDepthHaveNoVarianceAndNoFiniteBeta) {
  std::vector<std::pair<double, double>> taps(49, {0.7, 1.0 / 49.0});
  const RegionStatistics s = statisticsOf(regionOf(taps));
  EXPECT_EQ(s.mean, 0.7);
  EXPECT_EQ(s.min, s.max);
  EXPECT_TRUE(std::isinf(s.beta));
  EXPECT_GE(s.variance, 0.0);
  // The mean's rounding, squared.
  EXPECT_LE(s.variance, std::pow(49 * 2.3e-16, 2));
}

TEST(ReferenceVisibility, CountsEqualityAsLit) {
  const Region region = regionOf({{0.25, 0.5}, {0.5, 0.25}, {1.0, 0.25}});
  EXPECT_EQ(referenceVisibility(region, 0.0), 1.0);
  EXPECT_EQ(referenceVisibility(region, 0.25), 1.0);
  EXPECT_EQ(referenceVisibility(region, std::nextafter(0.25, 1.0)), 0.5);
  EXPECT_EQ(referenceVisibility(region, 0.5), 0.5);
  EXPECT_EQ(referenceVisibility(region, 1.0), 0.25);
  EXPECT_EQ(referenceVisibility(region, std::nextafter(1.0, 2.0)), 0.0);
}

}  // namespace
}  // namespace umbra
