#include "analysis/frame/ManyReads.h"

#include <gtest/gtest.h>

#include <random>

#include "analysis/probe/Probe.h"
#include "analysis/probe/TestMaps.h"

namespace umbra {
namespace {

// 7 × 7 taps, mixed four times, are at most 250 roundings of values up to 1. VSM answers to them
// most: its bound V/(V + D²) moves by (|dV| + 2|dM|)/V, with V at least its smallest variance of
// 1e-6, and |dV| at most three times |dM|.
constexpr double manyReadsTolerance = 250 * 1.2e-16 * 5 / 1e-6;

std::vector<MapRead> someReads(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<MapRead> reads{{0.0, 0.0, 0.5}, {1.0, 1.0, 0.5}, {0.5, 0.5, 0.5}};
  while (int(reads.size()) < count)
    reads.push_back({uniform(random), uniform(random), uniform(random)});
  return reads;
}

void expectAsProbed(const DepthMap& map, ReadFilter filter, std::string_view id) {
  const Kernel kernel{KernelShape::Box, 3};
  std::shared_ptr<Technique> technique = allTechniques().make(std::string(id));
  technique->adapt(map);
  const std::vector<MapRead> reads = someReads(300);
  const std::vector<ReadVisibility> found =
      evaluateReads({map, *technique, kernel, filter, StorageFormat::Double}, reads, [](double) {});
  ASSERT_EQ(found.size(), reads.size());
  for (std::size_t i = 0; i < reads.size(); ++i) {
    const Probe probe = takeProbe({.map = map,
                                   .read = {filter, reads[i].u, reads[i].v, {7.0, 7.0, 1}},
                                   .kernel = kernel,
                                   .receiver = reads[i].receiver,
                                   .techniques = {technique}});
    ASSERT_EQ(probe.techniques.size(), 1u);
    const double v = probe.techniques[0].visibility;
    ASSERT_NEAR(found[i].visibility, v, manyReadsTolerance) << reads[i].u << "," << reads[i].v;
    // Where all taps agree it is exact; else their weights are added up in the same order.
    ASSERT_NEAR(found[i].reference, probe.reference, 64 * 1.2e-16);
  }
}

// Maps wider than a tile and no multiple of one.
TEST(ManyReads, AreProbesOneByOne) {
  const DepthMap map = randomMap(150, 70, 5);
  for (ReadFilter filter : {ReadFilter::Point, ReadFilter::Bilinear, ReadFilter::SummedArea})
    for (const char* id : {"hard", "pcf", "vsm", "esm"}) {
      SCOPED_TRACE(std::string(nameOf(filter)) + " " + id);
      expectAsProbed(map, filter, id);
    }
}

TEST(ManyReads, ReadExtremesAndEverySample) {
  const DepthMap map = randomMap(70, 70, 8);
  expectAsProbed(map, ReadFilter::Bilinear, "power-cdf");
  DepthMap sampled(70, 70, 4);
  const DepthMap values = randomMap(280, 70, 9);
  std::ranges::copy(values.values(), sampled.values().begin());
  for (const char* id : {"pcf", "vsm", "power-cdf"}) {
    SCOPED_TRACE(id);
    expectAsProbed(sampled, ReadFilter::Bilinear, id);
  }
}

TEST(ManyReads, PercentageCloserFilteringHasNoError) {
  const DepthMap map = randomMap(100, 100, 6);
  const auto pcf = allTechniques().make("pcf");
  for (ReadFilter filter : {ReadFilter::Point, ReadFilter::Bilinear, ReadFilter::SummedArea})
    for (const auto& [visibility, reference] :
         evaluateReads({map, *pcf, {KernelShape::Box, 2}, filter}, someReads(500), [](double) {}))
      EXPECT_EQ(visibility, reference);
}

TEST(ManyReads, EndWhenProgressThrows) {
  const DepthMap map = randomMap(64, 64, 6);
  struct Stopped {};
  EXPECT_THROW(evaluateReads({map, *allTechniques().make("vsm"), {}}, someReads(10),
                             [](double) { throw Stopped{}; }),
               Stopped);
}

}  // namespace
}  // namespace umbra
