#include "analysis/cost/CostRatios.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbra {
namespace {

CostSamples someSamples() {
  CostSamples samples;
  for (double value : {30.0, 10.0, 20.0}) samples.add("vsm light", value);
  for (double value : {4.0, 100.0, 8.0}) samples.add("noShadow light", value);
  samples.add("nothing", 0.0);
  return samples;
}

TEST(CostRatios, AreQuotientsOfMedians) {
  const CostRatio ratio = ratioOf(someSamples(), {"vsm light", "noShadow light", 2.5});
  EXPECT_EQ(ratio.name, "vsm light / noShadow light");
  EXPECT_EQ(ratio.value, 20.0 / 8.0);
  EXPECT_TRUE(ratio.holds());  // a goal that is just met
  EXPECT_FALSE(ratioOf(someSamples(), {"vsm light", "noShadow light", 2.49}).holds());
}

TEST(CostRatios, MayBeOneMeasurementWithItsUnit) {
  const CostRatio ratio = ratioOf(someSamples(), {"vsm light", "", 19.0, "ms"});
  EXPECT_EQ(ratio.name, "vsm light");
  EXPECT_EQ(ratio.value, 20.0);
  EXPECT_EQ(ratio.unit, "ms");
  EXPECT_FALSE(ratio.holds());
}

// What was not measured, or cannot be divided by, has met no goal.
TEST(CostRatios, WithoutAValueMissTheirGoal) {
  for (const CostGoal& goal : {CostGoal{"vsm light", "csm light", 9.0},
                               {"csm light", "", 9.0},
                               {"vsm light", "nothing", 9.0}}) {
    const CostRatio ratio = ratioOf(someSamples(), goal);
    EXPECT_TRUE(std::isnan(ratio.value)) << ratio.name;
    EXPECT_FALSE(ratio.holds()) << ratio.name;
  }
}

TEST(CostRatios, NameThoseThatMissAndNoOthers) {
  const CostSamples samples = someSamples();
  const CostRatio ratios[] = {ratioOf(samples, {"vsm light", "noShadow light", 2.0}),
                              ratioOf(samples, {"vsm light", "noShadow light", 0.1}, false),
                              ratioOf(samples, {"noShadow light", "", 8.0}),
                              ratioOf(samples, {"csm light", "", 8.0})};
  EXPECT_EQ(missedIn(ratios),
            (std::vector<std::string>{"vsm light / noShadow light", "csm light"}));
}

TEST(CostSamples, KeepTheOrderInWhichTheirNamesCame) {
  EXPECT_EQ(someSamples().names(),
            (std::vector<std::string>{"vsm light", "noShadow light", "nothing"}));
  EXPECT_EQ(someSamples().spread("vsm light").count, 3u);
  EXPECT_EQ(someSamples().spread("csm light").count, 0u);
}

}  // namespace
}  // namespace umbra
