#include "ui/widgets/forms/SliderScale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbra {
namespace {

const SliderScale scales[] = {{0.0, 1e-2, true}, {1e-12, 1e-2, true}, {0.0, 0.99},
                              {0.0, 1.0},        {1.0, 88.0},         {1.0, 16.0, false, true},
                              {0.0, 0.05},       {-3.0, 5.0},         {1e-3, 10.0, true}};

TEST(SliderScale, EndsAreExact) {
  for (const SliderScale& scale : scales) {
    EXPECT_EQ(scale.valueAt(0), scale.low);
    EXPECT_EQ(scale.valueAt(scale.positions()), scale.high);
    EXPECT_EQ(scale.positionOf(scale.low), 0);
    EXPECT_EQ(scale.positionOf(scale.high), scale.positions());
  }
}

TEST(SliderScale, EveryPositionSurvivesTheWayThereAndBack) {
  for (const SliderScale& scale : scales) {
    double before = scale.low - 1.0;
    for (int position = 0; position <= scale.positions(); ++position) {
      const double value = scale.valueAt(position);
      EXPECT_GT(value, before) << "position " << position << " of " << scale.low;
      EXPECT_EQ(scale.positionOf(value), position) << "of " << scale.low << " … " << scale.high;
      before = value;
    }
  }
}

TEST(SliderScale, MiddleOfALogarithmicScaleIsTheGeometricMean) {
  const SliderScale scale{1e-12, 1e-2, true};
  EXPECT_NEAR(std::log10(scale.valueAt(scale.positions() / 2)), -7.0, 1e-12);
}

TEST(SliderScale, ValuesAreShort) {
  const SliderScale scale{0.0, 1.0};
  EXPECT_EQ(scale.valueAt(300), 0.3);  // not 0.30000000000000004
}

TEST(SliderScale, ValuesOutsideStandAtTheEnds) {
  const SliderScale scale{1.0, 88.0};
  EXPECT_EQ(scale.positionOf(-5.0), 0);
  EXPECT_EQ(scale.positionOf(1e9), scale.positions());
}

TEST(SliderScale, StepsStayWithinTheRange) {
  for (const SliderScale& scale : scales) {
    EXPECT_EQ(scale.stepped(scale.high, 1), scale.high);
    EXPECT_EQ(scale.stepped(scale.low, -1), scale.low);
    EXPECT_GT(scale.stepped(scale.low, 1), scale.low);
    EXPECT_LT(scale.stepped(scale.high, -1), scale.high);
  }
}

}  // namespace
}  // namespace umbra
