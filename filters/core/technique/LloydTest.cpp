#include "filters/core/technique/Lloyd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace umbra {
namespace {

std::vector<WeightedSample> randomSamples(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<WeightedSample> samples(count);
  for (WeightedSample& sample : samples) {
    const double centre = 0.25 * int(1 + 3 * uniform(random));
    sample = {centre + 0.2 * (uniform(random) - 0.5), uniform(random)};
  }
  return samples;
}

// Straight from the definition: Σ w·(x − nearest split)² / Σ w.
double costOf(const std::vector<WeightedSample>& samples, const std::vector<double>& splits) {
  double sum = 0.0, weight = 0.0;
  for (const WeightedSample& sample : samples) {
    double nearest = INFINITY;
    for (double split : splits) nearest = std::min(nearest, std::abs(sample.value - split));
    sum += sample.weight * nearest * nearest;
    weight += sample.weight;
  }
  return sum / weight;
}

TEST(Lloyd, SamplesTheSecondOccluder) {
  DepthMap map(2, 2, 1, 0.7);
  map(0, 0) = map(1, 0) = 0.2;
  const auto samples = secondOccluderSamples(map);
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_DOUBLE_EQ(samples[0].value, 0.7);      // max{a, b} for equal shares
  EXPECT_DOUBLE_EQ(samples[0].weight, 0.0625);  // ¼ (b − a)²
  EXPECT_EQ(secondOccluderSamples(map, {.low = 0.1})[0].weight, 0.1);
  EXPECT_EQ(secondOccluderSamples(map, {.high = 0.01})[0].weight, 0.01);
  EXPECT_TRUE(secondOccluderSamples(DepthMap(5, 1, 1, 0.5)).empty());
}

TEST(Lloyd, EndsWhereEverySplitIsTheMeanOfItsSamples) {
  const auto samples = randomSamples(1, 2000);
  const LloydResult result = relax(samples, {.splits = 5});
  ASSERT_EQ(result.splits.size(), 5u);
  EXPECT_TRUE(std::is_sorted(result.splits.begin(), result.splits.end()));
  std::vector<double> sums(5, 0.0), weights(5, 0.0);
  for (const WeightedSample& sample : samples) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < 5; ++k)
      if (std::abs(sample.value - result.splits[k]) <
          std::abs(sample.value - result.splits[nearest]))
        nearest = k;
    sums[nearest] += sample.weight * sample.value;
    weights[nearest] += sample.weight;
  }
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(result.splits[k], sums[k] / weights[k], 1e-12);
}

TEST(Lloyd, CostStartsAtTheUniformSplitsAndNeverRises) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto samples = randomSamples(seed, 500);
    const LloydResult result = relax(samples, {.splits = 4});
    ASSERT_EQ(result.cost.size(), std::size_t(result.iterations));
    EXPECT_NEAR(result.cost.front(), costOf(samples, {0.2, 0.4, 0.6, 0.8}), 1e-13);
    EXPECT_NEAR(result.cost.back(), costOf(samples, result.splits), 1e-13);
    for (std::size_t i = 1; i < result.cost.size(); ++i)
      EXPECT_LE(result.cost[i], result.cost[i - 1] + 1e-16);
  }
}

TEST(Lloyd, TwoSplitsAnIterationEndWhereNothingMovesEither) {
  const auto samples = randomSamples(3, 800);
  const LloydResult some = relax(samples, {.splits = 5, .movedPerIteration = 2});
  const LloydResult again = relax(samples, {.splits = 5, .start = some.splits});
  EXPECT_EQ(again.iterations, 1);
  EXPECT_EQ(again.splits, some.splits);
}

TEST(Lloyd, TeleportsASplitWithoutSamples) {
  // Everything lies near 0.9; uniform starts at ¼ and ½ are nearest to nothing.
  const std::vector<WeightedSample> samples{{0.88, 1.0}, {0.90, 1.0}, {0.92, 1.0}};
  const LloydResult result = relax(samples, {.splits = 3});
  EXPECT_EQ(result.teleports, 2);
  ASSERT_EQ(result.splits.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(result.splits[k], 0.88 + 0.02 * k, 1e-15);
  EXPECT_NEAR(result.cost.back(), 0.0, 1e-18);
}

TEST(Lloyd, StopsWithFewerValuesThanSplits) {
  const LloydResult result = relax({{0.5, 1.0}, {0.5, 2.0}}, {.splits = 3});
  EXPECT_EQ(result.teleports, 0);
  EXPECT_EQ(result.splits, (std::vector<double>{0.25, 0.5, 0.75}));
}

TEST(Lloyd, KeepsTheStartWhereNothingHasWeight) {
  const LloydResult result = relax({{0.4, 0.0}, {0.6, 0.0}}, {.splits = 1});
  EXPECT_EQ(result.splits, std::vector<double>{0.5});
  EXPECT_EQ(result.cost, std::vector<double>{0.0});
  EXPECT_TRUE(relax({}, {.splits = 0}).splits.empty());
}

TEST(Lloyd, StopsAfterTheIterationsAskedFor) {
  const LloydResult result = relax(randomSamples(5, 500), {.splits = 6, .maxIterations = 2});
  EXPECT_EQ(result.iterations, 2);
  EXPECT_EQ(result.cost.size(), 2u);
}

}  // namespace
}  // namespace umbra
