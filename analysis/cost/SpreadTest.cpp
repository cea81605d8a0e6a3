#include "analysis/cost/Spread.h"

#include <gtest/gtest.h>

#include <vector>

namespace umbra {
namespace {

TEST(Spread, OfNothingIsZero) {
  const Spread spread = spreadOf({});
  EXPECT_EQ(spread.count, 0u);
  EXPECT_EQ(spread.median, 0.0);
  EXPECT_EQ(medianError(spread), 0.0);
  EXPECT_FALSE(isSettled(spread, 1.0));
}

TEST(Spread, OfOneValueIsThatValue) {
  const Spread spread = spreadOf(std::vector{7.0});
  EXPECT_EQ(spread.q1, 7.0);
  EXPECT_EQ(spread.median, 7.0);
  EXPECT_EQ(spread.q3, 7.0);
}

// Five values have their quartiles among them; four have all three between two.
TEST(Spread, HasInterpolatedQuartilesWhateverTheOrder) {
  const Spread five = spreadOf(std::vector{5.0, 1.0, 4.0, 2.0, 3.0});
  EXPECT_EQ(five.q1, 2.0);
  EXPECT_EQ(five.median, 3.0);
  EXPECT_EQ(five.q3, 4.0);
  const Spread four = spreadOf(std::vector{8.0, 0.0, 4.0, 12.0});
  EXPECT_EQ(four.q1, 3.0);
  EXPECT_EQ(four.median, 6.0);
  EXPECT_EQ(four.q3, 9.0);
}

// 1.57 (4 − 2) / √5 is 1.404, that is 0.468 of the median.
TEST(Spread, IsSettledWhereTheMediansErrorIsSmall) {
  const Spread spread = spreadOf(std::vector{1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_NEAR(medianError(spread), 1.4042, 1e-4);
  EXPECT_TRUE(isSettled(spread, 0.47));
  EXPECT_FALSE(isSettled(spread, 0.46));
  EXPECT_TRUE(isSettled(spreadOf(std::vector{2.0, 2.0}), 0.0));
}

}  // namespace
}  // namespace umbra
