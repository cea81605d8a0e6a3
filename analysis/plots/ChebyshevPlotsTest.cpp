#include "analysis/plots/ChebyshevPlots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/plots/TwoOccludersForm.h"
#include "analysis/probe/TestProbes.h"

namespace umbra {
namespace {

// Linear between the samples of a curve, whose step is `step`.
double valueAt(const PlotSeries& series, double x) {
  const auto after = std::upper_bound(series.x.begin() + 1, series.x.end() - 1, x);
  const std::size_t i = after - series.x.begin();
  const double share = (x - series.x[i - 1]) / (series.x[i] - series.x[i - 1]);
  return std::lerp(series.y[i - 1], series.y[i], share);
}

TEST(ChebyshevPlots, TheBoundOfTwoDepthsIsTheShareOfTheFarther) {
  for (double p : {0.1, 0.5, 0.9}) {
    const Probe probe = probeOfDepths({0.3, 0.8}, 0.8, {1.0 - p, p});
    EXPECT_NEAR(chebyshevBound(probe.statistics.mean, probe.statistics.variance, 0.8), p, 1e-14);
  }
  EXPECT_EQ(chebyshevBound(0.5, 0.0, 0.5), 1.0);
  EXPECT_EQ(chebyshevBound(0.5, 0.0, 0.6), 0.0);
}

// Lauritzen 2008, eq. 3.4 as it is printed.
TEST(ChebyshevPlots, HalfAndHalfIsThePapersClosedForm) {
  for (double dx : {0.01, 0.2, 0.6})
    for (double dy : {0.01, 0.1, 0.4})
      EXPECT_NEAR(bleedingOfTwoOccluders(dx, dy),
                  0.25 * dx * dx / (0.5 * dx * dx + dx * dy + dy * dy), 1e-15);
  EXPECT_EQ(bleedingOfTwoOccluders(0.0, 0.2), 0.0);
  // On B itself what A leaves free is lit.
  EXPECT_NEAR(bleedingOfTwoOccluders(0.2, 0.0, 0.3), 0.7, 1e-15);
}

TEST(ChebyshevPlots, EveryShareIsTheBoundOfItsRegion) {
  for (double s : {0.05, 0.4, 0.8}) {
    const Probe probe = probeOfDepths({0.2, 0.5}, 0.75, {s, 1.0 - s});
    EXPECT_NEAR(bleedingOfTwoOccluders(0.3, 0.25, s),
                chebyshevBound(probe.statistics.mean, probe.statistics.variance, 0.75), 1e-14);
  }
}

// Whatever lies in a region: moved by nothing it has its own bound, and moved it has that of the
// depths that it then has.
TEST(ChebyshevPlots, MovedOccludersHaveTheBoundOfTheDepthsTheyThenHave) {
  for (const auto& depths : {std::vector{0.1, 0.15, 0.4, 0.9}, std::vector{0.2, 0.5},
                             std::vector{0.1, 0.3, 0.35, 0.36, 0.7, 0.95, 1.0}}) {
    const Probe probe = probeOfDepths(depths, 0.7);
    const auto occluders = Occluders::of(probe);
    ASSERT_TRUE(occluders);
    const RegionStatistics& s = probe.statistics;
    EXPECT_NEAR(occluders->boundAt(occluders->spread(), occluders->gap()),
                chebyshevBound(s.mean, s.variance, 0.7), 1e-13);
    const double farthest = 0.7 - occluders->gap();
    std::vector<double> moved = depths;
    for (double& depth : moved)
      if (depth < 0.7) depth = 0.6 - 0.5 * (farthest - depth);
    const RegionStatistics then = probeOfDepths(moved, 0.7).statistics;
    EXPECT_NEAR(occluders->boundAt(0.5 * occluders->spread(), 0.1),
                chebyshevBound(then.mean, then.variance, 0.7), 1e-13);
  }
  EXPECT_FALSE(Occluders::of(probeOfDepths({0.8, 0.9}, 0.8)));
  EXPECT_FALSE(Occluders::of(probeOfDepths({0.3, 0.3, 0.9}, 0.8)));
}

TEST(ChebyshevPlots, TheFamilyRisesWithTheVarianceAndHoldsTheBound) {
  const Probe probe = probeOfDepths({0.2, 0.5, 0.55}, 0.8);
  const Plot plot = varianceFamilyPlot(probe);
  ASSERT_EQ(plot.series.size(), 4u);
  const double factors[] = {0.5, 1.0, 2.0, 4.0};
  double before = probe.reference;
  for (std::size_t i = 0; i < 4; ++i) {
    const double value = valueAt(plot.series[i], 0.8);
    const double distance = 0.8 - probe.statistics.mean;
    const double variance = factors[i] * probe.statistics.variance;
    // Curved by less than 60 per depth², between samples 1/400 of at most 0.8 apart.
    EXPECT_NEAR(value, variance / (variance + distance * distance), 60.0 * 4e-6 / 8.0);
    EXPECT_GT(value, before);
    before = value;
  }
  ASSERT_EQ(plot.errors.size(), 1u);
  EXPECT_EQ(plot.errors[0].from, probe.reference);
  EXPECT_NEAR(plot.errors[0].to, valueAt(plot.series[1], 0.8), 3e-5);
}

// What is marked as this region is what the technique answers there, also where many occluders lie
// in front, and some texels are lit.
TEST(ChebyshevPlots, TheDistancePlotMarksTheTechniquesOwnVisibility) {
  for (const auto& depths : {std::vector{0.2, 0.5}, std::vector{0.1, 0.3, 0.35, 0.5, 0.9}}) {
    Probe probe = probeOfDepths(depths, 0.8);
    addResult(probe, allTechniques().make("vsm"));
    const Plot plot = occluderDistancePlot(probe).value();
    ASSERT_EQ(plot.series.size(), 3u);
    ASSERT_EQ(plot.errors.size(), 1u);
    EXPECT_NEAR(plot.errors[0].x, 0.5 - depths.front(), 1e-15);
    EXPECT_NEAR(plot.errors[0].from, probe.reference, 1e-15);
    EXPECT_NEAR(plot.errors[0].to, probe.techniques[0].visibility, 1e-12);
  }
  // The smaller the distance from B to C, the more bleeds.
  const Plot plot = occluderDistancePlot(probeOfDepths({0.2, 0.5}, 0.8)).value();
  for (double x : {0.1, 0.3, 0.5}) {
    EXPECT_GT(valueAt(plot.series[0], x), valueAt(plot.series[1], x));
    EXPECT_GT(valueAt(plot.series[1], x), valueAt(plot.series[2], x));
    EXPECT_NEAR(valueAt(plot.series[1], x), bleedingOfTwoOccluders(x, 0.3), 1e-4);
  }
  EXPECT_FALSE(occluderDistancePlot(probeOfDepths({0.9}, 0.5)));
}

}  // namespace
}  // namespace umbra
