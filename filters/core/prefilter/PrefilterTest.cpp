#include "filters/core/prefilter/Prefilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {
namespace {

// Depths, or values over forty orders of magnitude as the exponential techniques store them.
Image<double> noise(int width, int height, int channels, bool exponential) {
  Image<double> image(width, height, channels);
  std::mt19937 random(41);
  for (double& value : image.values()) {
    value = std::uniform_real_distribution(0.0, 1.0)(random);
    if (exponential) value = std::exp(92.0 * (value - 0.5));
  }
  return image;
}

const std::vector<Channel> everyReduction{
    {"mean", Reduction::Mean}, {"min", Reduction::Min}, {"max", Reduction::Max}};

// Straight from the definition.
double reduced(const Image<double>& image, const Channel& channel, int c, const Kernel& kernel,
               int x, int y) {
  const std::vector<double> weights = kernel.weights();
  const int r = kernel.effectiveRadius();
  double mean = 0.0, low = std::numeric_limits<double>::infinity(), high = -low;
  for (int j = -r; j <= r; ++j) {
    for (int i = -r; i <= r; ++i) {
      const double value = image(std::clamp(x + i, 0, image.width() - 1),
                                 std::clamp(y + j, 0, image.height() - 1), c);
      mean += weights[i + r] * weights[j + r] * value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return channel.reduction == Reduction::Mean  ? mean
         : channel.reduction == Reduction::Min ? low
                                               : high;
}

struct ReduceCase {
  int width, height;
  Kernel kernel;
};

class ReduceMap : public testing::TestWithParam<ReduceCase> {};

// Positive values lose only the rounding of their own sums: (2r+1)² terms, each with a relative
// error of 2u on either side, however large the values were that have left the window.
TEST_P(ReduceMap, FollowsTheDefinitionToFullRelativeAccuracy) {
  const auto& [width, height, kernel] = GetParam();
  for (bool exponential : {false, true}) {
    const Image<double> image = noise(width, height, 3, exponential);
    const Image<double> result = reduceMap(image, everyReduction, kernel);
    const double taps = std::pow(2 * kernel.effectiveRadius() + 1, 2);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double mean = reduced(image, everyReduction[0], 0, kernel, x, y);
        EXPECT_NEAR(result(x, y, 0), mean, (taps + 4) * 4.5e-16 * mean) << x << "," << y;
        EXPECT_EQ(result(x, y, 1), reduced(image, everyReduction[1], 1, kernel, x, y));
        EXPECT_EQ(result(x, y, 2), reduced(image, everyReduction[2], 2, kernel, x, y));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, ReduceMap,
    testing::Values(
        ReduceCase{17, 11, {KernelShape::Box, 1}}, ReduceCase{17, 11, {KernelShape::Box, 4}},
        ReduceCase{20, 20, {KernelShape::Gaussian, 3}},
        ReduceCase{5, 7, {KernelShape::Box, 9}},  // wider than the map
        ReduceCase{1, 1, {KernelShape::Box, 2}}, ReduceCase{1, 13, {KernelShape::Box, 2}},
        ReduceCase{9, 9, {KernelShape::Box, 4}},  // exactly one window
        ReduceCase{8, 6, {KernelShape::None, 5}}, ReduceCase{8, 6, {KernelShape::Box, 0}}));

TEST(ReduceMapOnce, LeavesAConstantAsItIs) {
  const Image<double> image(30, 20, 3, 0.3);
  for (const Kernel& kernel : {Kernel{KernelShape::Box, 5}, Kernel{KernelShape::Gaussian, 5}}) {
    const Image<double> reduced = reduceMap(image, everyReduction, kernel);
    for (double value : reduced.values()) EXPECT_NEAR(value, 0.3, 22 * 2.3e-16);
  }
}

TEST(ReduceMapOnce, LeavesNothingBehindALargeValue) {
  Image<double> image(64, 1, 1, 1e-20);
  image(5, 0) = 1e20;
  const std::vector<Channel> layout{{"mean", Reduction::Mean}};
  const Image<double> result = reduceMap(image, layout, {KernelShape::Box, 2});
  for (int x = 8; x < 64; ++x) EXPECT_NEAR(result(x, 0), 1e-20, 1e-34) << x;
}

DepthMap depths(int size) {
  DepthMap map(size, size);
  std::mt19937 random(43);
  for (double& depth : map.values()) depth = std::uniform_real_distribution(0.0, 1.0)(random);
  return map;
}

TEST(EncodeMap, StoresEveryTexelInItsFormat) {
  const DepthMap map = depths(6);
  const auto vsm = allTechniques().make("vsm");
  for (StorageFormat format : {StorageFormat::Unorm8, StorageFormat::Half, StorageFormat::Double}) {
    const Image<double> encoded = encodeMap(map, *vsm, format);
    ASSERT_EQ(encoded.channels(), 2);
    for (int y = 0; y < 6; ++y) {
      for (int x = 0; x < 6; ++x) {
        EXPECT_EQ(encoded(x, y, 0), stored(map(x, y), format));
        EXPECT_EQ(encoded(x, y, 1), stored(map(x, y) * map(x, y), format));
      }
    }
  }
}

TEST(StoreMap, UsesEachChannelsOwnRange) {
  Image<double> image(1, 1, 2);
  image(0, 0, 0) = 0.3;
  image(0, 0, 1) = -0.3;
  const std::vector<Channel> layout{{"a"}, {"b", Reduction::Mean, -1.0, 1.0}};
  storeMap(image, layout, StorageFormat::Unorm8);
  EXPECT_EQ(image(0, 0, 0), stored(0.3, StorageFormat::Unorm8));
  EXPECT_EQ(image(0, 0, 1), stored(-0.3, StorageFormat::Unorm8, -1.0, 1.0));
  EXPECT_NEAR(image(0, 0, 1), -0.3, 1.0 / 255.0);
}

TEST(PrefilteredRegion, IsTheMapsTexel) {
  const DepthMap map = depths(15);
  const Kernel kernel{KernelShape::Gaussian, 3};
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* technique : catalogue.all()) {
    const Image<double> whole = prefilteredMap(map, *technique, kernel, StorageFormat::Double);
    for (int x : {0, 7, 14}) {
      const auto one =
          prefilteredRegion(regionAtTexel(map, kernel, x, 5), *technique, StorageFormat::Double);
      ASSERT_EQ(int(one.size()), whole.channels());
      for (int c = 0; c < whole.channels(); ++c) {
        // Forty-nine products added in two orders; no term exceeds the largest encoded value.
        double largest = 0.0;
        std::vector<double> texel(one.size());
        for (const RegionTexel& tap : regionAtTexel(map, kernel, x, 5).texels) {
          technique->encode(tap.depth, texel);
          largest = std::max(largest, std::abs(texel[c]));
        }
        EXPECT_NEAR(one[c], whole(x, 5, c), 49 * 4.5e-16 * largest) << technique->info().id;
      }
    }
  }
}

TEST(ReadBilinear, MixesTheFourNearestStoredTexels) {
  const DepthMap map = depths(8);
  const auto technique = allTechniques().make("power-cdf");
  const Kernel kernel{KernelShape::Box, 1};
  const Image<double> whole = prefilteredMap(map, *technique, kernel, StorageFormat::Half);
  const double u = 0.3, v = 0.71;  // texels 1.9, 5.18: between 1 and 2, 5 and 6
  const auto read = readBilinear(map, *technique, kernel, StorageFormat::Half, u, v);
  const double fx = u * 8 - 0.5 - 1, fy = v * 8 - 0.5 - 5;
  for (int c = 0; c < whole.channels(); ++c) {
    const double top = (1 - fx) * whole(1, 5, c) + fx * whole(2, 5, c);
    const double bottom = (1 - fx) * whole(1, 6, c) + fx * whole(2, 6, c);
    EXPECT_NEAR(read[c], (1 - fy) * top + fy * bottom, 1e-15);
  }
  // Beyond the outermost texel centres there is nothing to mix.
  const auto corner = readBilinear(map, *technique, kernel, StorageFormat::Half, 0.0, 1.0);
  for (int c = 0; c < whole.channels(); ++c) EXPECT_NEAR(corner[c], whole(0, 7, c), 1e-15);
}

// Strips of a map are the same bits as the whole, where they begin with a window.
TEST(PrefilteredRows, AreThoseOfTheWholeMap) {
  const Image<double> image = noise(19, 47, 3, true);
  for (const Kernel& kernel : {Kernel{KernelShape::None, 0}, Kernel{KernelShape::Box, 2},
                               Kernel{KernelShape::Box, 8}, Kernel{KernelShape::Gaussian, 3}}) {
    const Image<double> whole = reduceMap(image, everyReduction, kernel);
    const int window = 2 * kernel.effectiveRadius() + 1, high = 2 * window;
    for (int first = 0; first < image.height(); first += high) {
      const Rows rows{first, std::min(high, image.height() - first)};
      const Rows known = reachedRows(kernel, rows, image.height());
      Image<double> part(image.width(), known.count, 3);
      std::copy_n(image.pixel(0, known.first).data(), part.values().size(), part.values().begin());
      const Image<double> found = reducedRows(part, everyReduction, kernel, known, rows);
      for (int y = 0; y < rows.count; ++y)
        for (int x = 0; x < image.width(); ++x)
          for (int c = 0; c < 3; ++c) EXPECT_EQ(found(x, y, c), whole(x, first + y, c));
    }
  }
}

}  // namespace
}  // namespace umbra
