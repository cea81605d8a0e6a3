#include "analysis/plots/PowerPlots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "analysis/plots/ProbePlots.h"
#include "analysis/probe/TestProbes.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// A region of n quantiles of t^β over [0.2, 0.8], and of its ends with hardly any weight.
Probe drawnFrom(double beta, int n) {
  std::vector<double> depths{0.2, 0.8}, weights{0.0, 0.0};
  for (int i = 0; i < n; ++i) {
    depths.push_back(0.2 + 0.6 * std::pow((i + 0.5) / n, 1.0 / beta));
    weights.push_back(1.0 / n);
  }
  return probeOfDepths(depths, 0.6, weights);
}

const PlotSeries& named(const Plot& plot, std::string_view beginning) {
  return *std::find_if(plot.series.begin(), plot.series.end(), [&](const PlotSeries& series) {
    return series.name.starts_with(beginning);
  });
}

TEST(PowerPlots, TheFunctionHasThePapersMean) {
  // ∫ z dF over t^β is min + (max − min) β/(β + 1): eq. 3 turned round.
  for (double beta : {0.5, 1.0, 2.0, 5.0}) {
    const RegionStatistics s{.min = 0.1, .max = 0.9, .beta = beta};
    double mean = s.max;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) mean -= 0.8 / n * powerCdf(s, 0.1 + 0.8 * (i + 0.5) / n);
    // Midpoint rule; the slope of t^½ is infinite at 0, where its error is below h^1.5.
    EXPECT_NEAR(mean, 0.1 + 0.8 * beta / (beta + 1.0), 4e-7);
  }
}

TEST(PowerPlots, IsAStepInItsLimits) {
  const RegionStatistics one = probeOfDepths({0.5}, 0.5).statistics;
  EXPECT_EQ(powerCdf(one, 0.4999), 0.0);
  EXPECT_EQ(powerCdf(one, 0.5), 1.0);
}

TEST(PowerPlots, TheFamilyHoldsThePowersAndTheRegion) {
  const Plot plot = powerFamilyPlot(probeOfDepths({0.2, 0.3, 0.8}, 0.5));
  ASSERT_EQ(plot.series.size(), 6u);
  for (double beta : {0.5, 1.0, 2.0, 5.0}) {
    const PlotSeries& series = plot.series[beta == 0.5 ? 0 : beta == 1.0 ? 1 : beta == 2.0 ? 2 : 3];
    for (std::size_t i = 0; i < series.x.size(); ++i)
      EXPECT_NEAR(series.y[i], std::pow(series.x[i], beta), 1e-15);
  }
  const PlotSeries& region = named(plot, "this region");
  EXPECT_EQ(region.x.back(), 1.0);
  EXPECT_EQ(region.y.back(), 1.0);
  EXPECT_NEAR(region.x[2], 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(region.y[2], 2.0 / 3.0, 1e-15);
  ASSERT_EQ(plot.markers.size(), 1u);
  EXPECT_NEAR(plot.markers[0].position, 0.5, 1e-15);
}

// What the technique answers and what the plot draws are one: also where a bilinear read
// interpolates the extremes of four texels, so that they are not those of the region.
TEST(PowerPlots, ShowTheFitThatTheTechniqueUses) {
  Probe probe = probeOfDepths({0.2, 0.3, 0.35, 0.8}, 0.5);
  addResult(probe, allTechniques().make("power-cdf"));
  EXPECT_FALSE(differs(powerFitOf(probe), probe.statistics));
  EXPECT_EQ(powerFamilyPlot(probe).series.size(), 6u);
  TechniqueResult& used = probe.techniques.front();
  used.channels = {0.41, 0.26, 0.74};
  // Gumbau 2011, eq. 4: the share of depths behind the receiver, as a part of that behind the mean.
  const auto visibilityOf = [&](double inFront, double z) {
    return z <= 0.41 ? 1.0 : (1.0 - inFront) / (1.0 - powerCdf(powerFitOf(probe), 0.41));
  };
  const auto usedAt = [&](double z) {
    return used.technique->visibility({used.channels, probe.region}, z);
  };
  for (const double z : {0.2, 0.3, 0.5, 0.7, 0.9})
    EXPECT_NEAR(visibilityOf(powerCdf(powerFitOf(probe), z), z), usedAt(z), 1e-12) << z;
  EXPECT_TRUE(differs(powerFitOf(probe), probe.statistics));
  const Plot family = powerFamilyPlot(probe);
  ASSERT_EQ(family.series.size(), 7u);
  const double beta = (0.41 - 0.26) / (0.74 - 0.41);
  const PlotSeries& inUse = named(family, "fit in use, β = " + shortNumber(beta));
  for (std::size_t i = 1; i + 1 < inUse.x.size(); ++i) {
    const double z = std::lerp(0.2, 0.8, inUse.x[i]);
    EXPECT_NEAR(visibilityOf(inUse.y[i], z), usedAt(z), 1e-12) << z;
  }
  const Plot cdf = cdfPlot(probe);
  EXPECT_NO_THROW(named(cdf, "power CDF t^β, β = " + shortNumber(beta)).x.at(0));
  EXPECT_NO_THROW(named(cdf, "this region's own fit").x.at(0));
  EXPECT_NE(residualPlot(probe).title.find("β = " + shortNumber(beta)), std::string::npos);
}

// Half a step of the empirical distribution, and β of n quantiles is off by at most (β+1)²/2n,
// which moves t^β by at most (β+1)²/(2nβe) < 1.5/n.
TEST(PowerPlots, ThereIsNoResidualWhereTheDepthsAreAPower) {
  constexpr int n = 400;
  for (double beta : {0.5, 1.0, 2.0, 5.0}) {
    const Plot plot = residualPlot(drawnFrom(beta, n));
    for (double residual : plot.series.front().y) EXPECT_LE(std::abs(residual), 2.0 / n) << beta;
  }
}

// Two depths: the fit is t^β with t̄ = p, the distribution 1 − p from the nearer one on. The
// difference is largest just at the nearer depth.
TEST(PowerPlots, TheLargestResidualOfTwoDepthsIsAtTheNearer) {
  const Plot plot = residualPlot(probeOfDepths({0.2, 0.8}, 0.5, {0.7, 0.3}));
  ASSERT_EQ(plot.errors.size(), 1u);
  EXPECT_EQ(plot.errors[0].x, 0.2);
  EXPECT_NEAR(plot.errors[0].to, -0.7, 1e-12);
}

TEST(PowerPlots, OneDepthHasNoResidual) {
  const Plot plot = residualPlot(probeOfDepths({0.5, 0.5}, 0.7));
  for (double residual : plot.series.front().y) EXPECT_EQ(residual, 0.0);
  EXPECT_TRUE(plot.errors.empty());
}

}  // namespace
}  // namespace umbra
