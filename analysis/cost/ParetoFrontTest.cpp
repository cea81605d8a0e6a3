#include "analysis/cost/ParetoFront.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

using Places = std::vector<std::size_t>;

TEST(ParetoFront, HoldsWhatNothingBeatsByAscendingCost) {
  const CostAndError choices[] = {{5, 0}, {1, 9}, {3, 4}, {4, 4}, {3, 5}, {9, 1}};
  EXPECT_EQ(paretoFront(choices), (Places{1, 2, 0}));
}

TEST(ParetoFront, HoldsEqualsTogether) {
  const CostAndError choices[] = {{2, 2}, {2, 2}, {2, 3}};
  EXPECT_EQ(paretoFront(choices), (Places{0, 1}));
}

TEST(ParetoFront, OfNothingIsEmpty) {
  EXPECT_TRUE(paretoFront({}).empty());
}

}  // namespace
}  // namespace umbra
