#include "analysis/plots/FourierPlots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/plots/PlotParts.h"
#include "analysis/probe/TestProbes.h"

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

// The slope of the series without attenuation is sin(2πMt)/sin(πt).
TEST(FourierPlots, HasItsFirstMaximumAtHalfOverM) {
  for (int terms = 1; terms <= 16; ++terms) {
    const FourierStep series(terms, 0.0);
    const double top = 1.0 / (2.0 * terms), h = 1e-4 / terms;
    EXPECT_GT(series(top), series(top - h));
    EXPECT_GT(series(top), series(top + h));
    EXPECT_NEAR(series(series.offset()), 1.0, 1e-12);
    EXPECT_LT(series.offset(), top);
  }
  EXPECT_NEAR(FourierStep(1, 0.0).offset(), std::asin(std::numbers::pi / 4) / std::numbers::pi,
              1e-12);
}

// Gibbs: the first maximum of a square wave's partial sums goes to ½ + Si(π)/π = 1.0895.
TEST(FourierPlots, RingsByGibbsConstant) {
  const FourierStep series(16, 0.0);
  // The sum is a midpoint rule of ∫ sin(x)/x over [0, π] with M = 16 intervals of h = π/16; the
  // integrand's second derivative is at most 1/3.
  const double h = std::numbers::pi / 16.0;
  EXPECT_NEAR(series(1.0 / 32.0), 0.5 + 1.851937051982466 / std::numbers::pi, h * h / 24.0 / 3.0);
  const Plot plot = fourierStepPlot(16, 0.0);
  ASSERT_EQ(plot.errors.size(), 1u);
  EXPECT_NEAR(plot.errors[0].x, 1.0 / 32.0, 1e-9);
  EXPECT_NEAR(plot.errors[0].to, series(1.0 / 32.0), 1e-9);
}

TEST(FourierPlots, TheOffsetIsTheMaximumWhereTheSeriesStaysBelowOne) {
  for (double attenuation : {3.0, 6.0, 10.0}) {
    const FourierStep series(1, attenuation);
    EXPECT_LT(series(0.5), 1.0);
    EXPECT_NEAR(series.offset(), 0.5, 1e-6);  // √ of the precision of a flat maximum
  }
}

// The formula told here is the one that the technique computes.
TEST(FourierPlots, AgreesWithTheTechniqueInBothModes) {
  for (int terms : {1, 3, 8, 16})
    for (double attenuation : {0.0, 0.7, 4.0}) {
      const FourierStep step(terms, attenuation);
      Probe probe = probeOfDepths({0.2, 0.21, 0.5, 0.7, 0.71}, 0.6);
      for (const char* mode : {"offset", "scale"}) {
        const auto csm = convolution(terms, attenuation, mode);
        const auto channels = prefilteredRegion(probe.region, *csm, StorageFormat::Double);
        for (double receiver : {0.05, 0.3, 0.45, 0.6, 0.705, 0.95}) {
          const bool moved = mode[0] == 'o';
          const double value =
              step.over(probe.region, {moved ? receiver - step.offset() : receiver})[0];
          // The place of a flat maximum is known to 1e-8 only, and there the slope is 0.
          EXPECT_NEAR(std::clamp(moved ? value : 2.0 * value, 0.0, 1.0),
                      csm->visibility({channels, probe.region}, receiver), 1e-7)
              << mode << " " << terms << " " << attenuation << " " << receiver;
        }
      }
    }
}

TEST(FourierPlots, TheModesLightTheirOwnDepth) {
  for (double attenuation : {0.0, 0.5}) {
    const Plot plot = fourierStepPlot(4, attenuation);
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

// More terms come nearer to the truth: compared in the mean over all receivers of the plot.
TEST(FourierPlots, MoreTermsComeNearerToTheTruth) {
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
