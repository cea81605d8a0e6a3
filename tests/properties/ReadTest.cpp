// Properties of every way to read a map, whatever the map holds.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/Composition.h"
#include "tests/properties/Draws.h"

namespace umbra {
namespace {

constexpr ReadFilter everyFilter[] = {ReadFilter::Point, ReadFilter::Bilinear,
                                      ReadFilter::Trilinear, ReadFilter::Anisotropic,
                                      ReadFilter::SummedArea};

std::map<std::pair<int, int>, double> weightsByTexel(const Region& region) {
  std::map<std::pair<int, int>, double> weights;
  for (const RegionTexel& texel : region.texels) weights[{texel.x, texel.y}] += texel.weight;
  return weights;
}

// Asserts that two regions weigh each texel alike; the weights were added in different orders.
void assertAlike(const Region& a, const Region& b) {
  const auto one = weightsByTexel(a), other = weightsByTexel(b);
  for (const auto& [texel, weight] : one)
    RC_ASSERT(std::abs(weight - (other.contains(texel) ? other.at(texel) : 0.0)) < 1e-13);
  for (const auto& [texel, weight] : other) RC_ASSERT(one.contains(texel) || weight < 1e-13);
}

class EveryFilter : public testing::TestWithParam<ReadFilter> {};

INSTANTIATE_TEST_SUITE_P(Reads, EveryFilter, testing::ValuesIn(everyFilter),
                         [](const auto& drawn) { return std::string(nameOf(drawn.param)); });

TEST_P(EveryFilter, WeighsTexelsOfTheMapByWeightsThatSumToOne) {
  rc::detail::checkGTest([&] {
    const DepthMap map = draws::map(8);
    const ReadPoint read = draws::read(map, GetParam());
    const Region region = regionOf(map, draws::kernel(), read);
    double sum = 0.0;
    for (const RegionTexel& texel : region.texels) {
      RC_ASSERT(texel.x >= 0 && texel.y >= 0 && texel.x < map.width() && texel.y < map.height());
      RC_ASSERT(texel.weight >= 0.0);
      sum += texel.weight;
    }
    RC_ASSERT(std::abs(sum - 1.0) < 1e-12);  // the sum of at most 10⁴ rounded weights
    RC_ASSERT(region.texels.size() % map.channels() == 0u);
  });
}

TEST_P(EveryFilter, ReadsTheMeanOfItsRegion) {
  const auto vsm = draws::make("vsm");
  rc::detail::checkGTest([&] {
    const DepthMap map = draws::map(8);
    const ReadPoint read = draws::read(map, GetParam());
    const Kernel kernel = draws::kernel();
    const auto channels = readChannels(map, *vsm, kernel, StorageFormat::Double, read);
    const RegionStatistics statistics = statisticsOf(regionOf(map, kernel, read));
    RC_ASSERT(std::abs(channels[0] - statistics.mean) < 1e-12);
    RC_ASSERT(std::abs(channels[1] - statistics.secondMoment) < 1e-12);
  });
}

TEST_P(EveryFilter, ReadsAConstantAsItIs) {
  const auto vsm = draws::make("vsm");
  rc::detail::checkGTest([&] {
    DepthMap map = draws::map(8);
    const double depth = draws::unit();
    std::ranges::fill(map.values(), depth);
    const auto channels = readChannels(map, *vsm, draws::kernel(), StorageFormat::Double,
                                       draws::read(map, GetParam()));
    RC_ASSERT(std::abs(channels[0] - depth) < 1e-12);
  });
}

TEST_P(EveryFilter, KeepsTheMeanBetweenMinimumAndMaximum) {
  const auto technique = draws::make("power-cdf");
  if (GetParam() == ReadFilter::SummedArea) {
    FrameSettings frame;
    frame.read.filter = GetParam();
    EXPECT_FALSE(whyImpossible(frame, *technique).empty());
    return;
  }
  rc::detail::checkGTest([&] {
    const DepthMap map = draws::map(8);
    const auto channels = readChannels(map, *technique, draws::kernel(), StorageFormat::Double,
                                       draws::read(map, GetParam()));
    RC_ASSERT(channels[1] <= channels[0] + 1e-12);
    RC_ASSERT(channels[0] <= channels[2] + 1e-12);
  });
}

TEST_P(EveryFilter, LeavesVarianceAnUpperBound) {
  const auto vsm = draws::make("vsm");
  rc::detail::checkGTest([&] {
    const DepthMap map = draws::map(8);
    const ReadPoint read = draws::read(map, GetParam());
    const Kernel kernel = draws::kernel();
    const Region region = regionOf(map, kernel, read);
    const double receiver = draws::receiverFor(region);
    const auto channels = readChannels(map, *vsm, kernel, StorageFormat::Double, read);
    // Moments are exact to 1e-12; the smallest variance of 1e-6 divides this.
    RC_ASSERT(vsm->visibility({channels, region}, receiver) >=
              referenceVisibility(region, receiver) - 1e-6);
  });
}

RC_GTEST_PROP(Trilinear, OfAFootprintOfOneTexelIsBilinear, ()) {
  const auto vsm = draws::make("vsm");
  const DepthMap map = draws::map(1);
  const Kernel kernel = draws::kernel();
  ReadPoint read = draws::read(map, ReadFilter::Bilinear);
  const auto bilinear = readChannels(map, *vsm, kernel, StorageFormat::Half, read);
  const Region region = regionOf(map, kernel, read);
  read.filter = ReadFilter::Trilinear;
  read.footprint = {draws::between(-0.7, 0.7), draws::between(-0.7, 0.7), 1};
  const auto trilinear = readChannels(map, *vsm, kernel, StorageFormat::Half, read);
  assertAlike(regionOf(map, kernel, read), region);
  // A prefiltered value on the edge between two halfs may be rounded either way.
  for (std::size_t c = 0; c < 2; ++c)
    RC_ASSERT(std::abs(trilinear[c] - bilinear[c]) <= 2.0 * unitRoundoff(StorageFormat::Half));
}

RC_GTEST_PROP(Anisotropic, OfOneProbeIsTrilinear, ()) {
  const auto vsm = draws::make("vsm");
  const DepthMap map = draws::map(4);
  const Kernel kernel = draws::kernel();
  ReadPoint read = draws::read(map, ReadFilter::Trilinear);
  const auto trilinear = readChannels(map, *vsm, kernel, StorageFormat::Half, read);
  read.filter = ReadFilter::Anisotropic;
  RC_ASSERT(readChannels(map, *vsm, kernel, StorageFormat::Half, read) == trilinear);
}

RC_GTEST_PROP(SummedArea, OfFixedSizeIsABilinearReadOfTheBoxKernel, ()) {
  const auto vsm = draws::make("vsm");
  const DepthMap map = draws::map(4);
  const Kernel kernel{KernelShape::Box, int(draws::between(0.0, 6.0))};
  ReadPoint read = draws::read(map, ReadFilter::Bilinear);
  const auto blurred = readChannels(map, *vsm, kernel, StorageFormat::Double, read);
  const Region region = regionOf(map, kernel, read);
  read.filter = ReadFilter::SummedArea;
  read.footprint.x = read.footprint.y = 2.0 * kernel.radius + 1.0;
  const auto summed = readChannels(map, *vsm, kernel, StorageFormat::Double, read);
  assertAlike(regionOf(map, kernel, read), region);
  for (std::size_t c = 0; c < 2; ++c) RC_ASSERT(std::abs(summed[c] - blurred[c]) < 1e-12);
}

// Blocks of a level move with the map.
RC_GTEST_PROP(Trilinear, MovesWithTheMapByWholeBlocks, ()) {
  const auto technique = draws::make("power-cdf");
  constexpr int size = 64, coarsest = 3, step = 1 << coarsest;
  DepthMap map(size, size), moved(size, size);
  for (double& depth : map.values()) depth = draws::unit();
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) moved(x, y) = map((x + size - step) % size, y);
  const Kernel kernel{KernelShape::Gaussian, 2};
  // Blocks and kernel stay off the border in both.
  ReadPoint read{ReadFilter::Trilinear,
                 draws::between(0.4, 0.6),
                 draws::between(0.4, 0.6),
                 {draws::between(0.0, step), 0.0, 1}};
  const auto before = readChannels(map, *technique, kernel, StorageFormat::Half, read);
  read.u += double(step) / size;
  const auto after = readChannels(moved, *technique, kernel, StorageFormat::Half, read);
  for (std::size_t c = 0; c < 3; ++c) RC_ASSERT(std::abs(after[c] - before[c]) < 1e-13);
}

}  // namespace
}  // namespace umbra
