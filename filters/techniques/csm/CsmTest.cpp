#include "filters/techniques/csm/Csm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "filters/core/prefilter/TestRegions.h"
#include "filters/techniques/csm/Waves.h"

namespace umbra {
namespace {

double visibilityOf(const csm::Csm& technique, double z, double receiver) {
  return test::visibilityOf(technique, test::regionOf({z}), receiver);
}

// With u = 2⁻⁵³: the first angle, πz, is off by πu at most, term k by 2k − 1 times that; each turn
// adds the roundings of the turn's own sine and cosine, 3u, and of two products and a sum, 2u. The
// angle c_k z of the other side is rounded twice.
TEST(Csm, WavesAreTheSinesAndCosinesOfTheirFrequencies) {
  for (int step = 0; step <= 1000; ++step) {
    const double z = step / 1000.0;
    csm::Waves waves(z);
    for (int k = 1; k <= csm::largestTermCount; ++k, waves.next()) {
      const double within = 0x1p-53 * (5.0 * k + csm::frequency(k) + 2.0 * csm::frequency(k));
      EXPECT_NEAR(waves.sine(), std::sin(csm::frequency(k) * z), within) << k << " " << z;
      EXPECT_NEAR(waves.cosine(), std::cos(csm::frequency(k) * z), within) << k << " " << z;
    }
  }
}

TEST(Csm, OneTermReachesOneWhereItsSineIsAQuarterPi) {
  EXPECT_NEAR(csm::FourierSeries(1, 0.0).offset(),
              std::asin(std::numbers::pi / 4) / std::numbers::pi, 1e-15);
  EXPECT_NEAR(csm::FourierSeries(1, 0.0).offset(), 0.28754, 5e-6);
}

// The slope of the unattenuated series is 2 Σ cos c_k t = sin(2πMt)/sin(πt), first 0 at 1/(2M).
TEST(Csm, UnattenuatedSeriesHasItsFirstMaximumAtHalfOverM) {
  for (int terms = 1; terms <= 16; ++terms) {
    const csm::FourierSeries series(terms, 0.0);
    const double top = 1.0 / (2.0 * terms), h = 1e-4 / terms;
    EXPECT_GT(series(top), 1.0);
    EXPECT_GT(series(top), series(top - h));
    EXPECT_GT(series(top), series(top + h));
    for (double t = 0.0; t < top - 0.05 / terms; t += 0.05 / terms)
      EXPECT_LT(series(t), series(t + 0.05 / terms));
    EXPECT_LT(series.offset(), top);
    EXPECT_NEAR(series(series.offset()), 1.0, 1e-14);
  }
}

// Where attenuation keeps the series below 1 the offset is its maximum.
TEST(Csm, OffsetIsTheMaximumWhereTheSeriesStaysBelowOne) {
  for (int terms : {1, 2, 4, 16}) {
    const csm::FourierSeries series(terms, 6.0);
    double top = 0.0;
    for (int i = 0; i <= 4000; ++i) top = std::max(top, series(i / 4000.0));
    if (top >= 1.0) continue;
    EXPECT_NEAR(series(series.offset()), top, 1e-6);
    EXPECT_GE(series(series.offset()), top);
  }
  EXPECT_LT(csm::FourierSeries(1, 6.0)(0.5), 1.0);
  EXPECT_NEAR(csm::FourierSeries(1, 6.0).offset(), 0.5, 1e-15);
}

// Eq. 13 is the shifted series itself for a single depth.
TEST(Csm, FollowsTheSeriesForOneDepth) {
  csm::Csm technique;
  technique.values = {.terms = 6, .attenuation = 0.7};
  const csm::FourierSeries series(6, 0.7);
  for (double receiver : {0.1, 0.3, 0.45, 0.5, 0.62, 0.9}) {
    EXPECT_NEAR(visibilityOf(technique, 0.5, receiver),
                std::clamp(series(0.5 - receiver + series.offset()), 0.0, 1.0), 1e-13);
  }
  technique.values.mode = csm::Mode::Scale;
  for (double receiver : {0.3, 0.49, 0.5, 0.51, 0.6})
    EXPECT_NEAR(visibilityOf(technique, 0.5, receiver),
                std::clamp(2.0 * series(0.5 - receiver), 0.0, 1.0), 1e-13);
}

TEST(Csm, LightsItsOwnDepthInBothModes) {
  csm::Csm technique;
  EXPECT_NEAR(visibilityOf(technique, 0.4, 0.4), 1.0, 1e-13);
  technique.values.mode = csm::Mode::Scale;
  EXPECT_NEAR(visibilityOf(technique, 0.4, 0.4), 1.0, 1e-13);
}

// The series has period 2: a receiver at the light over texels at the far plane is dark.
TEST(Csm, Wraps) {
  EXPECT_LT(visibilityOf(csm::Csm(), 1.0, 0.0), 0.1);
}

TEST(Csm, AParameterSetByItsNameRenewsTheSeries) {
  csm::Csm technique;
  parameterNamed(technique.parameters(), "terms", "test").set(9, "test");
  EXPECT_EQ(technique.series().terms(), 9);
  EXPECT_EQ(technique.channels().size(), 18u);
  EXPECT_EQ(technique.channels()[0].name, "S01");
  EXPECT_EQ(technique.channels()[17].name, "C09");
}

}  // namespace
}  // namespace umbra
