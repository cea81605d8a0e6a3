#include "analysis/plots/PlanesForm.h"

#include <gtest/gtest.h>

#include "analysis/plots/ChebyshevPlots.h"
#include "analysis/plots/TwoOccludersForm.h"
#include "analysis/probe/TestProbes.h"

namespace umbra {
namespace {

Probe measured(const std::vector<double>& depths, double receiver, std::vector<double> weights) {
  Probe probe = probeOfDepths(depths, receiver, std::move(weights));
  addResult(probe, allTechniques().make("vsm"));
  return probe;
}

TEST(PlanesForm, TwoPlanesShowTheUnoccludedShare) {
  for (double p : {0.1, 0.25, 0.5, 0.9}) {
    const std::vector<double> planes{0.45, 0.9};
    const auto prediction = predictPlanes(measured(planes, 0.9, {1.0 - p, p}), planes);
    ASSERT_TRUE(prediction);
    EXPECT_NEAR(prediction->ideal, p, 1e-14);
    EXPECT_NEAR(prediction->predicted, p, 1e-14);
    EXPECT_NEAR(prediction->measured, p, 1e-12);
  }
}

// Lauritzen 2008, eq. 3.4 for a half, and every other share.
TEST(PlanesForm, ThreePlanesBleedByTheClosedForm) {
  const std::vector<double> planes{0.12, 0.74, 0.94};
  for (double s : {0.1, 0.5, 0.8}) {
    const auto prediction = predictPlanes(measured({0.12, 0.74}, 0.94, {s, 1.0 - s}), planes);
    ASSERT_TRUE(prediction);
    EXPECT_NEAR(prediction->ideal, bleedingOfTwoOccluders(0.62, 0.20, s), 1e-14);
    EXPECT_NEAR(prediction->measured, prediction->ideal, 1e-12);
    EXPECT_EQ(prediction->planes.shares[2], 0.0);
  }
}

// At the border of B part of C is seen as well; a receiver with a bias is predicted with that bias.
TEST(PlanesForm, PredictsEveryMixtureAndBias) {
  const std::vector<double> planes{0.12, 0.74, 0.94};
  const Probe probe = measured(planes, 0.9395, {0.3, 0.5, 0.2});
  const auto prediction = predictPlanes(probe, planes);
  ASSERT_TRUE(prediction);
  EXPECT_NEAR(prediction->predicted, prediction->measured, 1e-12);
  EXPECT_GT(prediction->predicted, prediction->ideal);
}

TEST(PlanesForm, TheSmallestVarianceIsPredictedAsWell) {
  const std::vector<double> planes{0.5, 0.9};
  const auto prediction = predictPlanes(measured({0.5}, 0.501, {1.0}), planes);
  ASSERT_TRUE(prediction);
  EXPECT_NEAR(prediction->predicted, 0.5, 1e-9);  // σ²min = 1e-6 = distance²
  EXPECT_NEAR(prediction->measured, prediction->predicted, 1e-9);
}

TEST(PlanesForm, NothingIsPredictedOffThePlanesOrWithoutVsm) {
  const std::vector<double> planes{0.45, 0.9};
  EXPECT_FALSE(predictPlanes(measured({0.45, 0.6}, 0.9, {0.5, 0.5}), planes));
  EXPECT_FALSE(predictPlanes(probeOfDepths(planes, 0.9), planes));
  EXPECT_TRUE(predictPlanes(measured({0.45 + 1e-6, 0.9 - 1e-6}, 0.9, {0.5, 0.5}), planes));
}

TEST(PlanesForm, TheCurvesLieOverOneAnother) {
  const std::vector<double> planes{0.12, 0.74, 0.94};
  const Probe probe = measured({0.12, 0.74}, 0.94, {0.4, 0.6});
  const auto prediction = predictPlanes(probe, planes);
  ASSERT_TRUE(prediction);
  const Plot plot = planesPlot(probe, *prediction);
  ASSERT_EQ(plot.series.size(), 3u);
  for (std::size_t i = 0; i < plot.series[1].y.size(); ++i)
    EXPECT_NEAR(plot.series[1].y[i], plot.series[2].y[i], 1e-11);
  // Where there is less variance, the smallest variance of 1e-6 has an effect of at most 1e-6/Δy².
  const double clamp = 1e-6 / (0.2 * 0.2) + 1e-12;
  const Plot coverage = coveragePlot(probe, *prediction);
  const PlotSeries& form = coverage.series[0];
  for (std::size_t i = 0; i < form.x.size(); i += 40)
    EXPECT_NEAR(form.y[i], bleedingOfTwoOccluders(0.62, 0.20, form.x[i]), clamp) << form.x[i];
  EXPECT_EQ(coverage.series[1].x.front(), 0.4);
  EXPECT_NEAR(coverage.series[1].y.front(), bleedingOfTwoOccluders(0.62, 0.20, 0.4), 1e-12);
}

}  // namespace
}  // namespace umbra
