#include "analysis/plots/LloydRun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace umbra {
namespace {

std::vector<WeightedSample> randomSamples() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<WeightedSample> samples;
  for (int i = 0; i < 2000; ++i) samples.push_back({std::pow(unit(random), 3.0), unit(random)});
  return samples;
}

LloydRun finished(const std::vector<WeightedSample>& samples, std::vector<double> start) {
  LloydRun run(std::make_shared<SortedSamples>(samples), std::move(start));
  while (run.advance()) continue;
  return run;
}

TEST(LloydRun, EndsWhereTheRelaxationEnds) {
  const LloydRun run = finished(randomSamples(), {0.25, 0.5, 0.75});
  const LloydResult expected = relax(randomSamples(), {.splits = 3});
  EXPECT_EQ(run.frames().back().splits, expected.splits);
  ASSERT_GT(run.frames().size(), 2u);
  for (std::size_t i = 0; i < run.frames().size(); ++i)
    EXPECT_EQ(run.frames()[i].cost, expected.cost[i]) << "iteration " << i;
}

TEST(LloydRun, NeverCostsMore) {
  const std::vector<double> costs = finished(randomSamples(), {0.8, 0.9}).costs();
  for (std::size_t i = 1; i < costs.size(); ++i) EXPECT_LE(costs[i], costs[i - 1]);
}

TEST(LloydRun, CountsATeleportAsOneIteration) {
  // Both clusters are nearest to the first split: the second one has no samples.
  const std::vector<WeightedSample> samples{{0.1, 1.0}, {0.2, 1.0}};
  const LloydRun run = finished(samples, {0.15, 0.9});
  ASSERT_EQ(run.frames().size(), 2u);
  EXPECT_EQ(run.frames()[0].teleports, 0);
  EXPECT_EQ(run.frames()[1].teleports, 1);
  // Weighted sums about mid-depth are so exact.
  EXPECT_NEAR(run.frames()[1].splits[0], 0.1, 1e-15);
  EXPECT_NEAR(run.frames()[1].splits[1], 0.2, 1e-15);
}

TEST(LloydRun, HasNothingToDoWithoutSamplesOrSplits) {
  EXPECT_EQ(finished({}, {0.5}).frames().size(), 1u);
  EXPECT_EQ(finished({{0.5, 0.0}}, {0.5}).frames().size(), 1u);
  EXPECT_EQ(finished(randomSamples(), {}).frames().size(), 1u);
}

TEST(SortedSamples, CostIsTheMeanSquaredDistance) {
  const SortedSamples samples({{0.25, 1.0}, {0.5, 2.0}, {1.0, 1.0}, {0.75, 0.0}});
  // 1·0.25² + 2·0 + 1·0.25² over 4, with the splits 0.5 and 0.75: all are powers of two.
  EXPECT_EQ(samples.cost(std::vector<double>{0.5, 0.75}), 0.03125);
  EXPECT_EQ(samples.cost({}), 0.0);
}

}  // namespace
}  // namespace umbra
