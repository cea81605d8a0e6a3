#include "ui/widgets/plots/PlotReadout.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

TEST(PlotReadout, LinesAreStraightBetweenTheirPoints) {
  const PlotSeries line{"", "", SeriesStyle::Line, {0.0, 1.0, 3.0}, {0.0, 2.0, 0.0}};
  EXPECT_DOUBLE_EQ(*seriesValueAt(line, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(*seriesValueAt(line, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(*seriesValueAt(line, 3.0), 0.0);
  EXPECT_FALSE(seriesValueAt(line, -0.1));
  EXPECT_FALSE(seriesValueAt(line, 3.1));
}

TEST(PlotReadout, StepsHoldAndBarsSpanTheirEdges) {
  const PlotSeries steps{"", "", SeriesStyle::Steps, {0.0, 1.0, 2.0}, {5.0, 6.0, 7.0}};
  EXPECT_EQ(seriesValueAt(steps, 0.99), 5.0);
  EXPECT_EQ(seriesValueAt(steps, 1.0), 6.0);
  const PlotSeries bars{"", "", SeriesStyle::Bars, {0.0, 1.0, 2.0}, {5.0, 6.0}};
  EXPECT_EQ(seriesValueAt(bars, 0.5), 5.0);
  EXPECT_EQ(seriesValueAt(bars, 2.0), 6.0);
  EXPECT_FALSE(seriesValueAt(bars, 2.5));
}

TEST(PlotReadout, PointsAnswerWithTheNearest) {
  const PlotSeries points{"", "", SeriesStyle::Points, {0.0, 1.0}, {5.0, 6.0}};
  EXPECT_EQ(seriesValueAt(points, 0.6), 6.0);
}

TEST(PlotReadout, SeriesWithoutPointsHasNoValue) {
  EXPECT_FALSE(seriesValueAt(PlotSeries{}, 0.5));
}

TEST(PlotReadout, NamesEverySeriesThatHasAValue) {
  Plot plot;
  plot.xLabel = "z";
  plot.series = {{"A<B", "#2563c9", SeriesStyle::Line, {0.0, 1.0}, {0.0, 1.0}},
                 {"far", "#000000", SeriesStyle::Line, {2.0, 3.0}, {0.0, 1.0}}};
  const std::string text = readoutAt(plot, 0.5);
  EXPECT_NE(text.find("A&lt;B"), std::string::npos);
  EXPECT_NE(text.find("#2563c9"), std::string::npos);
  EXPECT_EQ(text.find("far"), std::string::npos);
}

TEST(PlotReadout, NamesTheBandsThatHoldX) {
  Plot plot;
  plot.bands = {{0.0, 0.5, "layer 1", "#112233"}, {0.5, 1.0, "layer 2", "#445566"}};
  EXPECT_NE(readoutAt(plot, 0.3).find("layer 1"), std::string::npos);
  EXPECT_EQ(readoutAt(plot, 0.3).find("layer 2"), std::string::npos);
}

}  // namespace
}  // namespace umbra
