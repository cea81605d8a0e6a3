// Mip levels, summed areas and samples against their definitions, on small maps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "filters/core/maps/MipLevels.h"
#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Error.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {
namespace {

DepthMap sampledNoise(int width, int height, int samples = 1) {
  DepthMap map(width, height, samples);
  std::mt19937 random(71);
  for (double& depth : map.values()) depth = std::uniform_real_distribution(0.0, 1.0)(random);
  return map;
}

// Computes level L of the whole map from the level below: P >> L texels a side, edges repeated.
Image<double> levelAbove(const Image<double>& below, int side, std::span<const Channel> layout,
                         StorageFormat format) {
  Image<double> level(side, side, below.channels());
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < below.channels(); ++c) {
        std::vector<double> four;
        for (int i = 0; i < 4; ++i)
          four.push_back(below(std::min(2 * x + i % 2, below.width() - 1),
                               std::min(2 * y + i / 2, below.height() - 1), c));
        const double mean = (four[0] + four[1] + four[2] + four[3]) / 4.0;
        level(x, y, c) = layout[c].reduction == Reduction::Min   ? std::ranges::min(four)
                         : layout[c].reduction == Reduction::Max ? std::ranges::max(four)
                                                                 : mean;
      }
  storeMap(level, layout, format);
  return level;
}

double bilinear(const Image<double>& level, double x, double y, int c) {
  const double px = x - 0.5, py = y - 0.5;
  const double fx = px - std::floor(px), fy = py - std::floor(py);
  const auto at = [&](double i, double j) {
    return level(std::clamp(int(i), 0, level.width() - 1),
                 std::clamp(int(j), 0, level.height() - 1), c);
  };
  const double left = std::floor(px), top = std::floor(py);
  return (1 - fy) * ((1 - fx) * at(left, top) + fx * at(left + 1, top)) +
         fy * ((1 - fx) * at(left, top + 1) + fx * at(left + 1, top + 1));
}

struct MipCase {
  int size;
  const char* technique;
  StorageFormat format;
};

class MipRead : public testing::TestWithParam<MipCase> {};

TEST_P(MipRead, IsThatOfThePyramidOfTheWholeMap) {
  const auto& [size, id, format] = GetParam();
  const DepthMap map = sampledNoise(size, size);
  const auto technique = allTechniques().make(id);
  const std::vector<Channel> layout = technique->channels();
  const Kernel kernel{KernelShape::Gaussian, 2};
  std::vector<Image<double>> pyramid{prefilteredMap(map, *technique, kernel, format)};
  const int levels = mipLevels(size, size), whole = 1 << levels;
  for (int level = 1; level <= levels; ++level)
    pyramid.push_back(levelAbove(pyramid.back(), whole >> level, layout, format));
  std::mt19937 random(73);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 60; ++trial) {
    const int probes = 1 + trial % 5;
    const double length = std::exp2(uniform(random) * (levels + 1.0)), turn = uniform(random) * 6.3;
    const ReadPoint read{ReadFilter::Anisotropic,
                         uniform(random),
                         uniform(random),
                         {length * std::cos(turn), length * std::sin(turn), probes}};
    const double lambda = std::clamp(std::log2(length / probes), 0.0, double(levels));
    const auto channels = readChannels(map, *technique, kernel, format, read);
    for (int c = 0; c < int(layout.size()); ++c) {
      double expected = 0.0;
      for (int i = 0; i < probes; ++i) {
        const double along = (i + 0.5) / probes - 0.5;
        const double x = read.u * size + read.footprint.x * along;
        const double y = read.v * size + read.footprint.y * along;
        for (int l = 0; l <= levels; ++l) {
          const double weight = std::max(0.0, 1.0 - std::abs(lambda - l)) / probes;
          if (weight > 0.0)
            expected += weight * bilinear(pyramid[l], std::ldexp(x, -l), std::ldexp(y, -l), c);
        }
      }
      // λ, the positions and forty products, each right to a few ε, of values of at most 1.
      EXPECT_NEAR(channels[c], expected, 1e-13) << "λ " << lambda;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, MipRead,
                         testing::Values(MipCase{16, "vsm", StorageFormat::Double},
                                         MipCase{16, "power-cdf", StorageFormat::Half},
                                         MipCase{13, "power-cdf", StorageFormat::Unorm8},
                                         MipCase{13, "vsm", StorageFormat::Float},
                                         MipCase{1, "vsm", StorageFormat::Half}));

TEST(MipLevels, EndAtOneTexel) {
  EXPECT_EQ(mipLevels(1, 1), 0);
  EXPECT_EQ(mipLevels(16, 16), 4);
  EXPECT_EQ(mipLevels(17, 3), 5);
}

TEST(MipLevels, AreThoseAboutTheFootprintsSize) {
  const auto levels = [](double footprint, int probes) {
    std::vector<std::pair<int, double>> found;
    for (const LevelRead& read :
         levelReadsOf({ReadFilter::Anisotropic, 0.5, 0.5, {footprint, 0.0, probes}}, 64, 64))
      found.emplace_back(read.level, read.weight);
    return found;
  };
  using Levels = std::vector<std::pair<int, double>>;
  EXPECT_EQ(levels(0.0, 1), (Levels{{0, 1.0}}));
  EXPECT_EQ(levels(1.0, 1), (Levels{{0, 1.0}}));
  EXPECT_EQ(levels(8.0, 1), (Levels{{3, 1.0}}));
  EXPECT_EQ(levels(8.0, 2), (Levels{{2, 0.5}, {2, 0.5}}));
  EXPECT_EQ(levels(1e9, 1), (Levels{{6, 1.0}}));
  const Levels between = levels(std::exp2(2.25), 1);
  ASSERT_EQ(between.size(), 2u);
  EXPECT_EQ(between[0].first, 2);
  EXPECT_EQ(between[1].first, 3);
  EXPECT_NEAR(between[1].second, 0.25, 1e-15);
}

TEST(SummedAreaRegion, WeighsTexelsByWhatTheBoxCovers) {
  const DepthMap map = sampledNoise(8, 8);
  // The box reaches from 2.25 to 4.75 along x and from 3 to 4 along y.
  const Region region = regionOf(map, {KernelShape::Box, 1},
                                 {ReadFilter::SummedArea, 3.5 / 8, 3.5 / 8, {2.5, 1.0, 1}});
  ASSERT_EQ(region.texels.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(region.texels[i].x, 2 + i);
    EXPECT_EQ(region.texels[i].y, 3);
    EXPECT_NEAR(region.texels[i].weight, i == 1 ? 0.4 : 0.3, 1e-15);
  }
}

TEST(SummedAreaRead, AddsUpStoredChannelsAndRoundsNoMore) {
  const DepthMap map = sampledNoise(8, 8);
  const auto vsm = allTechniques().make("vsm");
  const ReadPoint read{ReadFilter::SummedArea, 0.5, 0.5, {2.0, 2.0, 1}};
  const auto channels = readChannels(map, *vsm, {}, StorageFormat::Unorm8, read);
  double mean = 0.0;
  for (int y = 3; y < 5; ++y)
    for (int x = 3; x < 5; ++x) mean += stored(map(x, y), StorageFormat::Unorm8) / 4.0;
  EXPECT_NEAR(channels[0], mean, 1e-15);
}

TEST(SummedAreaRead, RefusesMinimaAndMaxima) {
  const DepthMap map = sampledNoise(4, 4);
  const auto technique = allTechniques().make("power-cdf");
  try {
    readChannels(map, *technique, {}, StorageFormat::Double,
                 {ReadFilter::SummedArea, 0.5, 0.5, {3.0, 3.0, 1}});
    ADD_FAILURE() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadCommandLine);
    EXPECT_NE(std::string(error.what()).find("power-cdf"), std::string::npos);
  }
}

TEST(Samples, AreEncodedBeforeTheyAreAveraged) {
  DepthMap map(1, 1, 2);
  map(0, 0, 0) = 0.2;
  map(0, 0, 1) = 0.6;
  const auto vsm = allTechniques().make("vsm");
  const Image<double> means = encodeMap(map, *vsm, StorageFormat::Double);
  EXPECT_NEAR(means(0, 0, 0), 0.4, 1e-16);
  EXPECT_NEAR(means(0, 0, 1), 0.5 * (0.04 + 0.36), 1e-16);
  const auto cdf = allTechniques().make("power-cdf");
  const Image<double> extremes = encodeMap(map, *cdf, StorageFormat::Double);
  EXPECT_NEAR(extremes(0, 0, 0), 0.4, 1e-16);
  EXPECT_EQ(extremes(0, 0, 1), 0.2);
  EXPECT_EQ(extremes(0, 0, 2), 0.6);
  // Rounded once, after the mean: 0.4 lies beside the mean of the two rounded depths.
  EXPECT_EQ(encodeMap(map, *vsm, StorageFormat::Unorm8)(0, 0, 0),
            stored(0.4, StorageFormat::Unorm8));
}

TEST(Samples, AreTapsOfTheRegion) {
  const DepthMap map = sampledNoise(5, 5, 4);
  const Region region = regionAtTexel(map, {KernelShape::Box, 1}, 2, 2);
  ASSERT_EQ(region.texels.size(), 36u);
  EXPECT_EQ(region.samples, 4);
  EXPECT_EQ(region.nearestDepth, map(2, 2, 0));
  for (int i = 0; i < 36; ++i) {
    EXPECT_EQ(region.texels[i].depth, map(region.texels[i].x, region.texels[i].y, i % 4));
    EXPECT_NEAR(region.texels[i].weight, 1.0 / 36.0, 1e-17);
  }
}

TEST(Samples, AreReducedLikeTheWholeMaps) {
  const DepthMap map = sampledNoise(9, 9, 8);
  const Kernel kernel{KernelShape::Gaussian, 2};
  for (const char* id : {"vsm", "power-cdf"}) {
    const auto technique = allTechniques().make(id);
    const Image<double> whole = prefilteredMap(map, *technique, kernel, StorageFormat::Half);
    for (int x : {0, 4, 8}) {
      const auto one =
          prefilteredRegion(regionAtTexel(map, kernel, x, 3), *technique, StorageFormat::Half);
      for (std::size_t c = 0; c < one.size(); ++c) EXPECT_EQ(one[c], whole(x, 3, int(c))) << id;
    }
  }
}

}  // namespace
}  // namespace umbra
