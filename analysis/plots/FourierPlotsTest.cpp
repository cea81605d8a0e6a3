#include "analysis/plots/FourierPlots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "analysis/plots/PlotParts.h"
#include "analysis/probe/TestProbes.h"
#include "filters/techniques/csm/FourierSeries.h"

namespace umbra {
namespace {

std::shared_ptr<Technique> convolution(int terms, double attenuation, const char* mode) {
  std::shared_ptr<Technique> csm = allTechniques().make("csm");
  const auto parameters = csm->parameters();
  parameterNamed(parameters, "terms", "test").set(terms, "test");
  parameterNamed(parameters, "attenuation", "test").set(attenuation, "test");
  parameterNamed(parameters, "mode", "test").set(std::string(mode), "test");
  return csm;
}

// Gibbs: the extremes of a square wave's partial sums go to ½ + Si(kπ)/π, 1.0895 and 0.9514. What
// swings beyond 0 and 1 is cut off: the second one is what is left, in shadow as light.
TEST(FourierPlots, MarksTheRingingThatTheClampLeaves) {
  const csm::FourierSeries series(16, 0.0);
  // The sum is a midpoint rule of ∫ sin(x)/x over [0, kπ] with intervals of h = π/16; the
  // integrand's second derivative is at most 1/3.
  const double h = std::numbers::pi / 16.0;
  EXPECT_NEAR(series(1.0 / 32.0), 0.5 + 1.851937051982466 / std::numbers::pi, h * h / 24.0 / 3.0);
  EXPECT_NEAR(series(2.0 / 32.0), 0.5 + 1.418151576132628 / std::numbers::pi,
              2.0 * h * h / 24.0 / 3.0);
  const double left = 1.0 - series(2.0 / 32.0);
  // The swing is found on a grid of 1/16384; the function's second derivative is below
  // 2·(32π)²·0.09.
  const double grid = 1.0 / 16384.0,
               most = grid * grid * 2.0 * std::pow(32.0 * std::numbers::pi, 2);
  for (const csm::Mode mode : {csm::Mode::Offset, csm::Mode::Scale}) {
    const Plot plot = fourierStepPlot(16, 0.0, mode);
    ASSERT_EQ(plot.errors.size(), 1u);
    EXPECT_EQ(plot.errors[0].from, 0.0);
    const bool offset = mode == csm::Mode::Offset;
    EXPECT_NEAR(plot.errors[0].x, -2.0 / 32.0 - (offset ? series.offset() : 0.0), grid);
    EXPECT_NEAR(plot.errors[0].to, offset ? left : 2.0 * left, most);
    for (const PlotSeries& drawn : plot.series)
      EXPECT_EQ(drawn.lineWidth == plot::thick,
                drawn.name.starts_with(offset ? "offset" : "scale"));
  }
  // One term swings nowhere beyond the step.
  EXPECT_TRUE(fourierStepPlot(1, 0.0, csm::Mode::Offset).errors.empty());
}

// What the plot draws for a number of terms is what the technique computes with it, clamped alike.
// The technique's series comes from its parameters as they are set by name.
TEST(FourierPlots, DrawTheTechniquesVisibility) {
  for (const auto& [attenuation, mode] : {std::pair(0.0, "offset"), std::pair(0.7, "scale"),
                                          std::pair(4.0, "offset"), std::pair(0.0, "scale")}) {
    Probe probe = probeOfDepths({0.2, 0.21, 0.5, 0.7, 0.71}, 0.6);
    addResult(probe, convolution(8, attenuation, mode));
    const Plot plot = fourierTermsPlot(probe);
    EXPECT_NE(plot.title.find(std::string(mode) + " mode"), std::string::npos);
    ASSERT_EQ(plot.series.size(), 6u);
    for (std::size_t i = 1; i < 6; ++i) {
      const auto csm = convolution(1 << (i - 1), attenuation, mode);
      const auto channels = prefilteredRegion(probe.region, *csm, StorageFormat::Double);
      const PlotSeries& drawn = plot.series[i];
      for (std::size_t k = 0; k < drawn.x.size(); k += 10)
        EXPECT_EQ(drawn.y[k], csm->visibility({channels, probe.region}, drawn.x[k]));
      EXPECT_EQ(drawn.lineWidth == plot::thick, i == 4) << "only the probe's 8 terms are thick";
    }
  }
}

TEST(FourierPlots, TheTermsInUseAreAmongThem) {
  Probe probe = probeOfDepths({0.2, 0.5}, 0.6);
  addResult(probe, convolution(5, 0.0, "offset"));
  const Plot plot = fourierTermsPlot(probe);
  ASSERT_EQ(plot.series.size(), 7u);
  EXPECT_EQ(plot.series[4].name, "M = 5");
  EXPECT_EQ(plot.series[4].lineWidth, plot::thick);
}

TEST(FourierPlots, TheModesLightTheirOwnDepth) {
  for (double attenuation : {0.0, 0.5}) {
    const Plot plot = fourierStepPlot(4, attenuation, csm::Mode::Offset);
    ASSERT_EQ(plot.series.size(), 5u);
    for (std::size_t i : {3u, 4u}) {
      const PlotSeries& mode = plot.series[i];
      const std::size_t middle = mode.x.size() / 2;
      EXPECT_NEAR(mode.x[middle], 0.0, 1e-15);
      EXPECT_NEAR(mode.y[middle], 1.0, 1e-12);
      for (double value : mode.y) EXPECT_TRUE(value >= 0.0 && value <= 1.0);
    }
    EXPECT_EQ(plot.series[2].dashed, attenuation == 0.0);
  }
}

TEST(FourierPlots, TakesItsParametersFromTheProbe) {
  Probe probe = probeOfDepths({0.2, 0.5}, 0.6);
  EXPECT_NE(fourierStepPlot(probe).title.find("M = 4"), std::string::npos);
  addResult(probe, convolution(9, 0.7, "offset"));
  EXPECT_NE(fourierStepPlot(probe).title.find("M = 9, α = 0.7"), std::string::npos);
}

// More terms come nearer to the reference: compared in the mean over all receivers of the plot.
TEST(FourierPlots, MoreTermsComeNearerToTheReference) {
  const Plot plot = fourierTermsPlot(probeOfDepths({0.3, 0.6}, 0.5));
  ASSERT_EQ(plot.series.size(), 6u);
  double before = 1.0;
  for (std::size_t i = 1; i < 6; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < plot.series[0].y.size(); ++k)
      sum += std::abs(plot.series[i].y[k] - plot.series[0].y[k]);
    EXPECT_LT(sum / double(plot.series[0].y.size()), before);
    before = sum / double(plot.series[0].y.size());
  }
}

}  // namespace
}  // namespace umbra
