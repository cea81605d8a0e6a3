#include "analysis/plots/MapPlots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "analysis/probe/TestMaps.h"
#include "analysis/probe/TestProbes.h"

namespace umbra {
namespace {

double sumOf(const std::vector<double>& values, std::size_t count) {
  return std::accumulate(values.begin(), values.begin() + count, 0.0);
}

TEST(MapPlots, SharesAddUpToOne) {
  const DepthMap map = randomMap(30, 20, 3);
  const Probe probe = takeProbe({.map = map,
                                 .read = ReadPoint::atTexel(map, 7, 9),
                                 .kernel = {KernelShape::Gaussian, 3},
                                 .receiver = 0.6});
  const Plot plot = mapHistogramPlot(map, probe, {.bins = 25, .logarithmic = false});
  ASSERT_EQ(plot.series.size(), 3u);
  for (const PlotSeries& series : plot.series) EXPECT_NEAR(sumOf(series.y, 25), 1.0, 1e-12);
  EXPECT_NE(plot.series[1].y, plot.series[2].y);  // a Gaussian does not weigh taps alike
  EXPECT_EQ(mapHistogramPlot(map, probe, {.kernelWeights = false}).series.size(), 2u);
}

TEST(MapPlots, CountsAreLogarithmsThatHoldEmptyBins) {
  DepthMap map(10, 10, 1, 1.0);  // 99 texels saw nothing
  map(3, 4) = 0.25;
  const Probe probe = takeProbe(
      {.map = map, .read = ReadPoint::atTexel(map, 3, 4), .kernel = {KernelShape::Box, 1}});
  const Plot plot = mapHistogramPlot(map, probe, {.bins = 10});
  EXPECT_NEAR(plot.series[0].y[9], 2.0, 1e-12);
  EXPECT_NEAR(plot.series[0].y[2], std::log10(2.0), 1e-12);
  EXPECT_EQ(plot.series[0].y[5], 0.0);
  EXPECT_NEAR(plot.series[1].y[9], std::log10(9.0), 1e-12);  // 8 of the 9 taps
  // A box weighs all taps alike.
  EXPECT_NEAR(plot.series[2].y[9], plot.series[1].y[9], 1e-12);
}

}  // namespace
}  // namespace umbra
