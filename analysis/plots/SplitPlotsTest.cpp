#include "analysis/plots/SplitPlots.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

TEST(WeightedHistogram, CountsWhatHasWeightAndSumsToOne) {
  const std::vector<double> values{0.0, 0.25, 0.5, 1.0, 0.9};
  const std::vector<double> weights{0.0, 2.0, 4.0, 2.0, 0.0};
  const Histogram histogram = histogramOf(values, weights, 3);
  EXPECT_EQ(histogram.edges, (std::vector<double>{0.25, 0.5, 0.75, 1.0}));
  EXPECT_EQ(histogram.weights, (std::vector<double>{0.25, 0.5, 0.25}));
}

TEST(WeightedHistogram, OfNothingIsEmpty) {
  const std::vector<double> values{0.3, 0.4}, weights{0.0, 0.0};
  EXPECT_TRUE(histogramOf(values, weights, 8).weights.empty());
  EXPECT_TRUE(histogramOf(values, weights, 8).edges.empty());
}

TEST(SplitsPlot, MarksEverySplitOverTheSamples) {
  const Histogram histogram{{0.25, 0.5, 0.75, 1.0}, {0.25, 0.5, 0.25}};
  const std::vector<double> splits{0.3, 0.6, 0.9};
  const Plot plot = splitsPlot(histogram, splits);
  ASSERT_EQ(plot.series.size(), 1u);
  EXPECT_EQ(plot.series[0].x, histogram.edges);
  EXPECT_EQ(plot.series[0].y, histogram.weights);
  ASSERT_EQ(plot.markers.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(plot.markers[k].position, splits[k]);
  EXPECT_EQ(plot.markers[2].label, "s3");
  EXPECT_NE(plot.title.find("4 layers"), std::string::npos);
}

TEST(SplitsPlot, ShowsSamplesBeyondTheFarPlane) {
  const Plot plot = splitsPlot({{0.5, 1.0, 1.5}, {0.5, 0.5}}, {});
  EXPECT_EQ(plot.xRange->high, 1.5);
  EXPECT_NE(plot.title.find("1 layer"), std::string::npos);
}

TEST(SplitsPlot, IsSensibleWithoutSamplesAndWithOneDepth) {
  EXPECT_TRUE(splitsPlot({}, std::vector<double>{0.5}).series.empty());
  EXPECT_EQ(splitsPlot({}, std::vector<double>{0.5}).markers.size(), 1u);
  const Plot plot = splitsPlot({{0.5, 0.5}, {1.0}}, {});
  EXPECT_LT(plot.series[0].x[0], plot.series[0].x[1]);
}

TEST(LayersPlot, CutsDepthIntoBandsAndHatchesTheirOverlaps) {
  const std::vector<double> splits{0.3, 0.6, 0.9};
  const std::vector<std::string> colours{"#111111", "#222222"};
  const Plot plot = layersPlot({{0.25, 1.0}, {1.0}}, splits, 0.02, colours);
  ASSERT_EQ(plot.bands.size(), 4u + 3u);
  const double bounds[] = {0.0, 0.3, 0.6, 0.9, 1.0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(plot.bands[i].low, bounds[i]);
    EXPECT_EQ(plot.bands[i].high, bounds[i + 1]);
    EXPECT_EQ(plot.bands[i].colour, colours[i % 2]);
    EXPECT_FALSE(plot.bands[i].hatched);
  }
  // Lauritzen 2008, §4.1.1: widened by the overlap, but not at 0 and 1.
  EXPECT_EQ(plot.bands[0].name, "layer 1 covers 0–0.32");
  EXPECT_EQ(plot.bands[1].name, "layer 2 covers 0.28–0.62");
  EXPECT_EQ(plot.bands[3].name, "layer 4 covers 0.88–1");
  EXPECT_TRUE(plot.bands[4].hatched);
  EXPECT_DOUBLE_EQ(plot.bands[4].low, 0.28);
  EXPECT_DOUBLE_EQ(plot.bands[4].high, 0.32);
  for (const PlotMarker& marker : plot.markers) EXPECT_TRUE(marker.draggable);
  EXPECT_EQ(layersPlot({}, splits, 0.0, colours).bands.size(), 4u);
  EXPECT_EQ(layersPlot({}, {}, 0.02, colours).bands.size(), 1u);
}

TEST(CostPlot, SetsUniformBesideTheIterations) {
  const Plot plot = costPlot(std::vector<double>{0.25, 0.125}, 0.5, 1);
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[1].x, std::vector<double>{1.0});
  EXPECT_EQ(plot.series[1].y, std::vector<double>{0.125});
  ASSERT_EQ(plot.markers.size(), 1u);
  EXPECT_EQ(plot.markers[0].axis, MarkerAxis::Horizontal);
  EXPECT_EQ(plot.markers[0].position, 0.5);
  EXPECT_GE(plot.yRange->high, 0.5);
}

TEST(CostPlot, CountsIterationsFromZero) {
  const Plot plot = costPlot(std::vector<double>{0.5, 0.25, 0.25});
  ASSERT_EQ(plot.series.size(), 1u);
  EXPECT_EQ(plot.series[0].x, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(plot.series[0].y, (std::vector<double>{0.5, 0.25, 0.25}));
  EXPECT_TRUE(plot.wholeX);
  for (const auto& cost : {std::vector<double>{}, std::vector<double>{0.0}}) {
    const Plot flat = costPlot(cost);
    EXPECT_LT(flat.xRange->low, flat.xRange->high);
    EXPECT_LT(flat.yRange->low, flat.yRange->high);
  }
}

}  // namespace
}  // namespace umbra
