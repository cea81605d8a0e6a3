#include "analysis/plots/CostPlots.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

TEST(ErrorAgainstCost, MarksEveryPointAndTheLeastErrorForACost) {
  const CostPoint points[] = {
      {"PCF", "#111111", 50, 0.0}, {"VSM", "#222222", 10, 0.25}, {"CSM", "#333333", 20, 0.5}};
  const Plot plot = errorAgainstCostPlot(points);
  ASSERT_EQ(plot.series.size(), 4u);
  const PlotSeries& front = plot.series[0];
  EXPECT_EQ(front.style, SeriesStyle::Steps);
  ASSERT_EQ(front.x.size(), 3u);
  EXPECT_EQ(front.x[0], 10);
  EXPECT_EQ(front.x[1], 50);
  EXPECT_EQ(front.x[2], plot.xRange->high);
  EXPECT_EQ(front.y, (std::vector<double>{0.25, 0.0, 0.0}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(plot.series[i + 1].style, SeriesStyle::Points);
    EXPECT_EQ(plot.series[i + 1].name, points[i].name);
    EXPECT_EQ(plot.series[i + 1].x, std::vector{points[i].milliseconds});
    EXPECT_EQ(plot.series[i + 1].y, std::vector{points[i].rmse});
    EXPECT_GT(plot.xRange->high, points[i].milliseconds);
    EXPECT_GT(plot.yRange->high, points[i].rmse);
  }
}

TEST(ErrorAgainstCost, WithoutErrorOrPointsHasAnEmptyRangeNowhere) {
  const CostPoint exact[] = {{"PCF", "#111111", 0.0, 0.0}};
  for (const Plot& plot : {errorAgainstCostPlot({}), errorAgainstCostPlot(exact)}) {
    EXPECT_GT(plot.xRange->high, plot.xRange->low);
    EXPECT_GT(plot.yRange->high, plot.yRange->low);
  }
}

}  // namespace
}  // namespace umbra
