// Plots on widgets of every size, and their labels' places.
#include <gtest/gtest.h>
#include <qwt_legend.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_item.h>
#include <qwt_scale_div.h>

#include <cmath>
#include <set>

#include "tests/plots/SamplePlots.h"
#include "ui/plots/LabelPlacer.h"
#include "ui/plots/PlotFitter.h"
#include "ui/plots/PlotRenderer.h"
#include "ui/plots/SeriesItem.h"

namespace umbra {
namespace {

TEST(LabelPlacer, TakesTheFirstPlaceWhereAllAreFree) {
  LabelPlacer placer({0, 0, 200, 100});
  const QRectF first(10, 10, 40, 12), second(60, 10, 40, 12);
  EXPECT_EQ(placer.place({first, second}), first);
}

TEST(LabelPlacer, KeepsLabelsApart) {
  LabelPlacer placer({0, 0, 200, 100});
  std::vector<QRectF> candidates;
  for (int row = 0; row < 6; ++row) candidates.emplace_back(10, 2 + 14 * row, 60, 14);
  std::vector<QRectF> placed;
  for (int label = 0; label < 6; ++label) placed.push_back(placer.place(candidates));
  for (std::size_t i = 0; i < placed.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(placed[i].intersects(placed[j])) << i << " and " << j;
}

TEST(LabelPlacer, AvoidsCurvesAndBars) {
  LabelPlacer placer({0, 0, 200, 100});
  placer.avoid(QLineF(0, 16, 200, 16));
  placer.avoid(QRectF(60, 30, 40, 60));
  const QRectF onCurve(10, 10, 40, 12), onBar(60, 40, 40, 12), free(120, 40, 40, 12);
  EXPECT_EQ(placer.place({onCurve, onBar, free}), free);
}

TEST(LabelPlacer, StaysInsideEvenOverACurve) {
  LabelPlacer placer({0, 0, 200, 100});
  placer.avoid(QLineF(0, 16, 200, 16));
  const QRectF outside(180, 40, 40, 12), onCurve(10, 10, 40, 12);
  EXPECT_EQ(placer.place({outside, onCurve}), onCurve);
}

TEST(LabelPlacer, IgnoresWhatIsNotFinite) {
  LabelPlacer placer({0, 0, 200, 100});
  placer.avoid(QLineF(0, std::nan(""), 200, 16));
  placer.avoid(QLineF(0, 50, 1e9, 50));
  const QRectF free(10, 10, 40, 12);
  EXPECT_EQ(placer.place({free}), free);
}

class PlotSizes : public testing::TestWithParam<QSize> {};

TEST_P(PlotSizes, CurvesKeepMostOfTheWidget) {
  const DepthMap map = leavesOverBench();
  const Probe probe = sampleProbe(map);
  QwtPlot widget;
  for (const Plot& plot : {histogramPlot(probe), curvesPlot(probe, "vsm"), cdfPlot(probe)}) {
    widget.resize(GetParam());
    showPlot(widget, plot);
    widget.updateLayout();
    const QSize canvas = widget.canvas()->size();
    // Axes, title and a legend of every technique leave the curves at least a quarter.
    EXPECT_GE(4 * canvas.width() * canvas.height(), GetParam().width() * GetParam().height())
        << plot.name << " " << canvas.width() << "x" << canvas.height();
  }
}

INSTANTIATE_TEST_SUITE_P(All, PlotSizes,
                         testing::Values(QSize(320, 200), QSize(400, 250), QSize(480, 320),
                                         QSize(300, 500), QSize(720, 440), QSize(900, 600)));

TEST(ShowPlot, ReplacesWhatWasThere) {
  const DepthMap map = leavesOverBench();
  const Probe probe = sampleProbe(map);
  const auto seriesIn = [](const QwtPlot& widget) {
    std::multiset<std::string> names;
    for (const QwtPlotItem* item : widget.itemList())
      if (dynamic_cast<const SeriesItem*>(item)) names.insert(item->title().text().toStdString());
    return names;
  };
  const auto seriesOf = [](const Plot& plot) {
    std::multiset<std::string> names;
    for (const PlotSeries& series : plot.series) names.insert(series.name);
    return names;
  };
  QwtPlot widget;
  widget.resize(720, 440);
  for (const Plot& plot : {curvesPlot(probe, "vsm"), histogramPlot(probe), cdfPlot(probe)}) {
    showPlot(widget, plot);
    EXPECT_EQ(seriesIn(widget), seriesOf(plot));
    EXPECT_EQ(widget.title().text().toStdString(), plot.title);
    // One series needs no legend: the title names it.
    EXPECT_EQ(widget.legend() != nullptr, plot.series.size() > 1);
  }
  EXPECT_EQ(&PlotFitter::of(widget), &PlotFitter::of(widget));
}

TEST(ShowPlot, FitsTheAxesWhereNoRangeIsGiven) {
  Plot plot{.name = "cost", .title = "Cost"};
  plot.series.push_back(
      {"cost", "#3f6fb5", SeriesStyle::Points, {0, 1, 2, 3}, {9.0, 5.0, 4.0, 4.0}});
  QwtPlot widget;
  widget.resize(400, 300);
  showPlot(widget, plot);
  EXPECT_LE(widget.axisScaleDiv(QwtPlot::xBottom).lowerBound(), 0.0);
  EXPECT_GE(widget.axisScaleDiv(QwtPlot::xBottom).upperBound(), 3.0);
  EXPECT_LE(widget.axisScaleDiv(QwtPlot::yLeft).lowerBound(), 4.0);
  EXPECT_GE(widget.axisScaleDiv(QwtPlot::yLeft).upperBound(), 9.0);
}

TEST(ShowPlot, CountsInWholeNumbersWhereAsked) {
  for (double last : {1.0, 3.0, 40.0, 731.0}) {
    Plot plot{.name = "cost", .title = "Cost", .xRange = PlotRange{0.0, last}, .wholeX = true};
    plot.series.push_back({"cost", "#3f6fb5", SeriesStyle::Line, {0.0, last}, {9.0, 5.0}});
    for (QSize size : {QSize(320, 200), QSize(900, 600)}) {
      QwtPlot widget;
      widget.resize(size);
      showPlot(widget, plot);
      const auto ticks = widget.axisScaleDiv(QwtPlot::xBottom).ticks(QwtScaleDiv::MajorTick);
      EXPECT_GE(ticks.size(), 2);
      EXPECT_LE(ticks.size(), 12);
      for (double tick : ticks) EXPECT_EQ(tick, std::round(tick)) << last;
    }
  }
}

TEST(ShowPlot, SurvivesAnEmptyPlot) {
  QwtPlot widget;
  widget.resize(320, 200);
  showPlot(widget, Plot{});
  showPlot(widget, Plot{.series = {PlotSeries{.name = "nothing", .colour = "#000000"}}});
  EXPECT_FALSE(widget.grab().isNull());
}

}  // namespace
}  // namespace umbra
