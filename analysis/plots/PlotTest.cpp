#include "analysis/plots/Plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "analysis/plots/ProbePlots.h"
#include "analysis/probe/TestMaps.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

Probe probeOf(const DepthMap& map, double receiver) {
  return takeProbe({.map = map,
                    .read = ReadPoint::atTexel(map, map.width() / 2, map.height() / 2),
                    .kernel = {KernelShape::Box, 4},
                    .receiver = receiver,
                    .techniques = everyTechnique(map)});
}

// The properties that the drawing of plots relies on.
void expectDrawable(const Plot& plot) {
  EXPECT_FALSE(plot.name.empty());
  EXPECT_FALSE(plot.title.empty());
  EXPECT_FALSE(plot.series.empty());
  for (const PlotSeries& series : plot.series) {
    ASSERT_FALSE(series.y.empty()) << series.name;
    EXPECT_EQ(series.x.size(), series.y.size() + (series.style == SeriesStyle::Bars ? 1 : 0));
    EXPECT_TRUE(std::is_sorted(series.x.begin(), series.x.end())) << series.name;
    for (double value : series.x) EXPECT_TRUE(std::isfinite(value)) << series.name;
    for (double value : series.y) EXPECT_TRUE(value >= 0.0 && value <= 1.0) << series.name;
    EXPECT_EQ(series.colour.size(), 7u);
  }
  for (const auto& range : {plot.xRange, plot.yRange}) {
    if (!range) continue;
    EXPECT_LT(range->low, range->high);
  }
}

const PlotMarker* markerNamed(const Plot& plot, std::string_view label) {
  for (const PlotMarker& marker : plot.markers)
    if (marker.label == label) return &marker;
  return nullptr;
}

TEST(Csv, SharesColumnsOfEqualX) {
  Plot plot{.name = "p", .xLabel = "z"};
  plot.series.push_back({"a", "#000000", SeriesStyle::Line, {0, 1}, {0.1, 0.25}});
  plot.series.push_back({"b", "#000000", SeriesStyle::Line, {0, 1}, {1e-300, -2}});
  plot.series.push_back({"c", "#000000", SeriesStyle::Bars, {0, 0.5, 1}, {0.5, 0.75}});
  EXPECT_EQ(toCsv(plot), "z,a,b,z,c\n0,0.1,1e-300,0,0.5\n1,0.25,-2,0.5,0.75\n,,,1,\n");
}

TEST(Csv, QuotesWhatNeedsIt) {
  Plot plot{.xLabel = "z, normalised", .yLabel = "v"};
  plot.series.push_back({"a \"b\"", "#000000", SeriesStyle::Line, {0}, {1}});
  plot.series.push_back({"", "#000000", SeriesStyle::Line, {0}, {2}});
  EXPECT_EQ(toCsv(plot), "\"z, normalised\",\"a \"\"b\"\"\",v\n0,1,2\n");
}

TEST(Csv, RefusesAFolderThatIsAFile) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "here";
  try {
    writeCsv(Plot{}, folder / "file" / "plot.csv");
    ADD_FAILURE() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadOutput);
    EXPECT_NE(std::string(error.what()).find("plot.csv"), std::string::npos);
  }
}

TEST(HistogramPlot, ShowsEveryBinAndMarksTheStatistics) {
  const DepthMap map = randomMap(32, 32, 11);
  const Probe probe = probeOf(map, 0.7);
  const Plot plot = histogramPlot(probe, 40);
  expectDrawable(plot);
  EXPECT_EQ(plot.series[0].y, histogramOf(probe.region, 40).weights);
  const RegionStatistics& s = probe.statistics;
  const std::pair<const char*, double> expected[] = {{"min", s.min},
                                                     {"mean μ", s.mean},
                                                     {"μ + σ", s.mean + std::sqrt(s.variance)},
                                                     {"max", s.max},
                                                     {"receiver", 0.7}};
  for (const auto& [label, position] : expected) {
    ASSERT_NE(markerNamed(plot, label), nullptr) << label;
    EXPECT_EQ(markerNamed(plot, label)->position, position);
  }
  EXPECT_EQ(markerNamed(plot, "receiver")->colour, probeColour);
  EXPECT_EQ(plot.title, "Depths in the region · 81 texels · 40 bins");
}

TEST(CurvesPlot, EmphasisesTheSelectedTechniqueAndMarksItsError) {
  const DepthMap map = randomMap(32, 32, 12);
  const Probe probe = probeOf(map, 0.85);
  const Plot plot = curvesPlot(probe, "vsm");
  expectDrawable(plot);
  ASSERT_EQ(plot.series.size(), probe.techniques.size() + 1);
  EXPECT_EQ(plot.series.front().name, "exact");
  EXPECT_EQ(plot.series.back().name, "VSM");
  for (std::size_t i = 1; i + 1 < plot.series.size(); ++i)
    EXPECT_LT(plot.series[i].lineWidth, plot.series.back().lineWidth);
  ASSERT_EQ(plot.errors.size(), 1u);
  const PlotError& error = plot.errors[0];
  EXPECT_EQ(error.x, 0.85);
  EXPECT_EQ(error.from, probe.reference);
  EXPECT_GT(error.to, error.from);
  EXPECT_EQ(error.label.rfind("bleeding +0.", 0), 0u) << error.label;
  EXPECT_EQ(error.colour, errorColour);
}

TEST(CurvesPlot, NamesOverDarkening) {
  const DepthMap map = randomMap(32, 32, 13);
  Probe probe = probeOf(map, 0.85);
  for (TechniqueResult& result : probe.techniques) {
    result.visibility = 0.25;
    result.error = -0.1;
  }
  probe.reference = 0.35;
  const Plot plot = curvesPlot(probe, "vsm");
  ASSERT_EQ(plot.errors.size(), 1u);
  EXPECT_EQ(plot.errors[0].label, "over-darkening −0.100");
}

TEST(CurvesPlot, MarksNoErrorWhereThereIsNone) {
  const DepthMap map = randomMap(32, 32, 14);
  EXPECT_TRUE(curvesPlot(probeOf(map, 0.85), "pcf").errors.empty());
  EXPECT_TRUE(curvesPlot(probeOf(map, 0.85), "").errors.empty());
}

TEST(CdfPlot, ShowsTheDistributionAndBothFits) {
  const DepthMap map = randomMap(32, 32, 15);
  const Probe probe = probeOf(map, 0.85);
  const Plot plot = cdfPlot(probe);
  expectDrawable(plot);
  ASSERT_EQ(plot.series.size(), 3u);
  for (const PlotSeries& series : plot.series) {
    EXPECT_TRUE(std::is_sorted(series.y.begin(), series.y.end())) << "a distribution never falls";
    EXPECT_EQ(series.y.front(), 0.0);
  }
  EXPECT_NE(plot.series[1].name.find("β = " + shortNumber(probe.statistics.beta)),
            std::string::npos);
  // Cantelli's bound is never above the distribution behind the mean.
  const EmpiricalCdf cdf = empiricalCdfOf(probe.region);
  for (std::size_t i = 0; i < plot.series[2].x.size(); ++i) {
    const double z = plot.series[2].x[i];
    const auto above = std::lower_bound(cdf.depth.begin(), cdf.depth.end(), z);
    const auto index = above - cdf.depth.begin();
    const double inFront = index == 0 ? 0.0 : cdf.cumulative[index - 1];
    EXPECT_LE(plot.series[2].y[i], inFront + 1e-12) << z;
  }
  ASSERT_EQ(plot.errors.size(), 1u);
  EXPECT_EQ(plot.errors[0].x, 0.85);
  EXPECT_EQ(plot.errors[0].from, 1.0 - probe.reference);
}

TEST(ProbePlots, AreSensibleForARegionOfOneDepth) {
  const DepthMap map(16, 16, 1, 0.5);
  for (double receiver : {0.0, 0.5, 0.75, 1.0}) {
    const Probe probe = probeOf(map, receiver);
    for (const Plot& plot : {histogramPlot(probe), curvesPlot(probe, "vsm"), cdfPlot(probe)})
      expectDrawable(plot);
    const Plot histogram = histogramPlot(probe);
    ASSERT_EQ(histogram.series[0].y.size(), 1u);
    EXPECT_EQ(histogram.series[0].y[0], 1.0);
    EXPECT_LT(histogram.series[0].x[0], histogram.series[0].x[1]) << "wide enough to be seen";
    EXPECT_EQ(histogram.markers.size(), 1u) << "mean, min and max are the bar itself";
    EXPECT_TRUE(cdfPlot(probe).errors.empty());
  }
}

}  // namespace
}  // namespace umbra
