#include "analysis/errors/CompareMap.h"

#include <gtest/gtest.h>

#include "analysis/probe/Probe.h"
#include "analysis/probe/TestMaps.h"

namespace umbra {
namespace {

// Both ways add at most 121 products of one value and one weight, in different orders: n · 2u ·
// max.
constexpr double tapRounding = 121 * 2.3e-16;

// Compares by a probe at every texel.
std::vector<Metrics> byBruteForce(const DepthMap& map,
                                  const std::vector<std::shared_ptr<const Technique>>& techniques,
                                  const Kernel& kernel, StorageFormat format, double receiver) {
  std::vector<MetricsSum> sums(techniques.size());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const Probe probe = takeProbe({.map = map,
                                     .read = ReadPoint::atTexel(map, x, y),
                                     .kernel = kernel,
                                     .format = format,
                                     .receiver = receiver,
                                     .techniques = techniques});
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i].add(probe.techniques[i].visibility, probe.reference);
    }
  }
  std::vector<Metrics> results;
  for (const MetricsSum& sum : sums) results.push_back(sum.result());
  return results;
}

class CompareMap : public testing::TestWithParam<Kernel> {};

TEST_P(CompareMap, AgreesWithAProbeAtEveryTexel) {
  const DepthMap map = randomMap(23, 17, 21);
  const auto techniques = everyTechnique(map);
  for (double receiver : {0.3, 0.5, 0.87}) {
    const auto found = compareOnMap(map, techniques, GetParam(), StorageFormat::Double, receiver);
    const auto expected =
        byBruteForce(map, techniques, GetParam(), StorageFormat::Double, receiver);
    ASSERT_EQ(found.size(), techniques.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::string_view id = techniques[i]->info().id;
      EXPECT_EQ(found[i].samples, 23u * 17u);
      // A visibility's slope in its channels is at most 1/σ²min and the like; 1e-9 is what the
      // command line promises against another evaluation of the formulas.
      EXPECT_NEAR(found[i].rmse, expected[i].rmse, 1e-9) << id;
      EXPECT_NEAR(found[i].mae, expected[i].mae, 1e-9) << id;
      EXPECT_NEAR(found[i].bleeding, expected[i].bleeding, 1e-9) << id;
      EXPECT_NEAR(found[i].darkening, expected[i].darkening, 1e-9) << id;
      EXPECT_NEAR(found[i].max, expected[i].max, 1e-9) << id;
      EXPECT_NEAR(found[i].min, expected[i].min, 1e-9) << id;
      EXPECT_NEAR(found[i].umbraBleeding, expected[i].umbraBleeding, 1e-9) << id;
    }
  }
}

TEST_P(CompareMap, ReferenceIsThatOfEveryRegion) {
  const DepthMap map = randomMap(23, 17, 22);
  for (double receiver : {0.0, 0.2, 0.5, 0.81, 1.0}) {
    const Image<double> reference = referenceMap(map, GetParam(), receiver);
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const double expected = referenceVisibility(regionAtTexel(map, GetParam(), x, y), receiver);
        EXPECT_NEAR(reference(x, y), expected, tapRounding);
        EXPECT_EQ(reference(x, y) == 0.0, expected == 0.0) << "the umbra is exact";
        EXPECT_LE(reference(x, y), 1.0);
      }
    }
  }
}

// A disc of taps lies about a texel as far as the region reaches.
TEST_P(CompareMap, AgreesWithAProbeWhereTapsAreSampled) {
  const DepthMap map = randomMap(23, 17, 21);
  const std::shared_ptr<Technique> sampled = allTechniques().make("pcf");
  parameterNamed(sampled->parameters(), "taps", "pcf").set(std::string("poisson"), "pcf.taps");
  const auto found = compareOnMap(map, std::vector<std::shared_ptr<const Technique>>{sampled},
                                  GetParam(), StorageFormat::Double, 0.5);
  const auto expected = byBruteForce(map, {sampled}, GetParam(), StorageFormat::Double, 0.5);
  EXPECT_NEAR(found[0].rmse, expected[0].rmse, 1e-12);
  EXPECT_NEAR(found[0].max, expected[0].max, 1e-12);
  EXPECT_NEAR(found[0].min, expected[0].min, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Kernels, CompareMap,
                         testing::Values(Kernel{KernelShape::None, 3}, Kernel{KernelShape::Box, 1},
                                         Kernel{KernelShape::Box, 5},
                                         Kernel{KernelShape::Gaussian, 3}));

TEST(CompareMapOnce, PercentageCloserHasNoErrorAtAll) {
  const DepthMap map = randomMap(16, 16, 23);
  const std::vector<std::shared_ptr<const Technique>> techniques{allTechniques().make("pcf")};
  const auto found =
      compareOnMap(map, techniques, {KernelShape::Gaussian, 4}, StorageFormat::Double, 0.55);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].max, 0.0);
  EXPECT_EQ(found[0].min, 0.0);
  EXPECT_EQ(found[0].rmse, 0.0);
}

TEST(CompareMapOnce, KeepsTheOrderOfTheTechniques) {
  const DepthMap map = randomMap(16, 16, 24);
  const Kernel kernel{KernelShape::Box, 2};
  const TechniqueCatalogue catalogue = allTechniques();
  const std::vector<std::shared_ptr<const Technique>> one{
      catalogue.make("vsm"), catalogue.make("hard"), catalogue.make("pcf")};
  const std::vector<std::shared_ptr<const Technique>> other{one[2], one[0], one[1]};
  const auto a = compareOnMap(map, one, kernel, StorageFormat::Float, 0.7);
  const auto b = compareOnMap(map, other, kernel, StorageFormat::Float, 0.7);
  EXPECT_EQ(a[0].rmse, b[1].rmse);
  EXPECT_EQ(a[1].rmse, b[2].rmse);
  EXPECT_EQ(a[2].rmse, b[0].rmse);
  EXPECT_NE(a[0].rmse, a[1].rmse);
}

// An exception that the caller throws between two strips ends the work, for either kind of
// technique.
TEST(CompareMapOnce, EndsWhereTheCallerThrows) {
  const DepthMap map = randomMap(16, 4096, 26);
  const TechniqueCatalogue catalogue = allTechniques();
  struct Stopped {};
  for (const char* id : {"vsm", "pcf"}) {
    const std::vector<std::shared_ptr<const Technique>> one{catalogue.make(id)};
    int calls = 0;
    const auto stop = [&calls] {
      if (++calls == 3) throw Stopped();
    };
    EXPECT_THROW(compareOnMap(map, one, {KernelShape::Box, 2}, StorageFormat::Double, 0.5, stop),
                 Stopped)
        << id;
    EXPECT_EQ(calls, 3) << id;
  }
}

// Without a prefilter every region is one blocking texel: only vsm's smallest variance makes it
// bleed, by Lauritzen 2008, eq. 3.3.
TEST(CompareMapOnce, FindsTheClosedFormOfSingleTexels) {
  const double a = 0.2, b = 0.6, c = 0.75;
  DepthMap map(8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) map(x, y) = (x + y) % 2 == 0 ? a : b;
  const std::vector<std::shared_ptr<const Technique>> techniques{allTechniques().make("vsm")};
  const auto found =
      compareOnMap(map, techniques, {KernelShape::None, 0}, StorageFormat::Double, c);
  const auto bound = [&](double z) { return 1e-6 / (1e-6 + (c - z) * (c - z)); };
  EXPECT_NEAR(found[0].umbraBleeding, (bound(a) + bound(b)) / 2, 1e-12);
  EXPECT_NEAR(found[0].max, bound(b), 1e-12);
  EXPECT_NEAR(found[0].min, bound(a), 1e-12);
}

}  // namespace
}  // namespace umbra
