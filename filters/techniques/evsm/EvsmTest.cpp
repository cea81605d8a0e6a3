#include "filters/techniques/evsm/Evsm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/core/prefilter/TestRegions.h"
#include "filters/techniques/vsm/Vsm.h"

namespace umbra {
namespace {

using test::regionOf;
using test::visibilityOf;

// Lauritzen 2008, §3.2, holds in every monotone warp.
TEST(Evsm, IsExactForOneOccluderOverAPlane) {
  for (double p : {0.1, 0.25, 0.5, 0.9}) {
    const Region region = regionOf({0.3, 0.8}, {1 - p, p});
    EXPECT_NEAR(visibilityOf(evsm::Evsm2(), region, 0.8), p, 1e-12);
    EXPECT_NEAR(visibilityOf(evsm::Evsm4(), region, 0.8), p, 1e-12);
  }
}

// Eq. 3.4 with the warped distances of the three planes.
TEST(Evsm, BleedsByTheClosedFormOfThreePlanesInTheWarp) {
  evsm::Evsm2 technique;
  technique.values.positiveExponent = 10.0;
  const double a = 0.2, b = 0.6, c = 0.75;
  const auto g = [](double z) { return std::exp(10.0 * (z - 0.5)); };
  const double dx = g(b) - g(a), dy = g(c) - g(b);
  const double expected = 0.25 * dx * dx / (0.5 * dx * dx + dx * dy + dy * dy);
  EXPECT_NEAR(visibilityOf(technique, regionOf({a, b}, {0.5, 0.5}), c), expected, 1e-12);
}

TEST(Evsm, FourMomentsGiveTheSmallerOfTwoBounds) {
  const Region region = regionOf({0.1, 0.4, 0.45, 0.9}, {0.3, 0.3, 0.2, 0.2});
  evsm::Evsm2 rising;
  evsm::Evsm4 both;
  // The mirrored warp is the rising one of mirrored depth.
  for (double receiver : {0.2, 0.42, 0.5, 0.8, 0.95}) {
    double m1 = 0.0, m2 = 0.0;
    for (const RegionTexel& texel : region.texels) {
      const double g = -std::exp(-5.0 * (texel.depth - 0.5));
      m1 += texel.weight * g;
      m2 += texel.weight * g * g;
    }
    const double t = -std::exp(-5.0 * (receiver - 0.5));
    const double variance = std::max(m2 - m1 * m1, 1e-6 * 25.0 * t * t);
    const double mirrored = t <= m1 ? 1.0 : variance / (variance + (t - m1) * (t - m1));
    EXPECT_NEAR(visibilityOf(both, region, receiver),
                std::min(mirrored, visibilityOf(rising, region, receiver)), 1e-12);
  }
}

// A flat warp is a linear one: as c goes to 0 the bound goes to that of VSM, linearly in c.
TEST(Evsm, GoesToVsmForAFlatWarp) {
  const Region region = regionOf({0.2, 0.35, 0.6}, {0.5, 0.25, 0.25});
  evsm::Evsm2 technique;
  const double limit = visibilityOf(vsm::Vsm(), region, 0.7);
  technique.values.positiveExponent = 0.2;
  const double far = std::abs(visibilityOf(technique, region, 0.7) - limit);
  technique.values.positiveExponent = 0.1;
  const double near = std::abs(visibilityOf(technique, region, 0.7) - limit);
  EXPECT_LT(near, 0.01);
  EXPECT_NEAR(far / near, 2.0, 0.05);
}

TEST(Evsm, LimitsExponentsToTheFormat) {
  evsm::Evsm4 technique;
  EXPECT_TRUE(technique.limitTo(StorageFormat::Double).empty());
  EXPECT_TRUE(technique.limitTo(StorageFormat::Float).empty());
  const auto notes = technique.limitTo(StorageFormat::Half);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "evsm4.positive-exponent 40 is beyond what half floats hold; 11 is used");
  EXPECT_EQ(technique.values.negativeExponent, 5.0);
  technique.values.negativeExponent = 12.0;
  EXPECT_EQ(technique.limitTo(StorageFormat::Half).size(), 1u);
  for (double z : {0.0, 1.0}) {
    std::vector<double> channels(4);
    technique.encode(z, channels);
    for (double value : channels) EXPECT_LT(std::abs(value), largestOf(StorageFormat::Half));
  }
}

TEST(Evsm, RefusesNormalisedFormats) {
  EXPECT_FALSE(evsm::Evsm2().refusal(StorageFormat::Unorm8).empty());
  EXPECT_FALSE(evsm::Evsm4().refusal(StorageFormat::Unorm16).empty());
  EXPECT_TRUE(evsm::Evsm4().refusal(StorageFormat::Float).empty());
}

}  // namespace
}  // namespace umbra
