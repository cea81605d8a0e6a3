#include "filters/techniques/msm/Msm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "filters/core/prefilter/TestRegions.h"
#include "filters/techniques/msm/Hamburger.h"
#include "filters/techniques/vsm/Vsm.h"

namespace umbra {
namespace {

using test::regionOf;
using test::visibilityOf;

// A biased two-depth region has depths 0, a, b, 1. With the receiver on b the extreme distribution
// may be that one with 0 and a drawn together; its error vanishes with the bias.
TEST(Msm, GoesToTheExactShareOfTwoDepthsAsTheBiasGoes) {
  for (double p : {0.1, 0.5, 0.9}) {
    const Region region = regionOf({0.3, 0.8}, {1 - p, p});
    double last = 1.0;
    for (double bias : {1e-3, 1e-4, 1e-5, 1e-6}) {
      msm::Msm technique;
      technique.values.momentBias = bias;
      const double error = std::abs(visibilityOf(technique, region, 0.8) - p);
      EXPECT_LT(error, last);
      last = error;
    }
    EXPECT_LT(last, 1e-3);
  }
}

// Three planes (Lauritzen 2008, fig. 3.4): two occluders are two depths, which four moments
// resolve.
TEST(Msm, DoesNotBleedBelowTwoOccluders) {
  const Region region = regionOf({0.2, 0.6}, {0.5, 0.5});
  EXPECT_GT(visibilityOf(vsm::Vsm(), region, 0.75), 0.2);
  EXPECT_LT(visibilityOf(msm::Msm(), region, 0.75), 0.01);
}

// The last pivot is of the order of the bias squared, 1e-9, and divides moments that are rounded to
// 1e-16: results hold to 1e-7.
constexpr double rounding = 1e-7;

TEST(Msm, BoundsTheReferenceUpToHalfTheBias) {
  const Region region = regionOf({0.1, 0.3, 0.45, 0.6, 0.9}, {0.2, 0.1, 0.3, 0.25, 0.15});
  for (double receiver = 0.0; receiver <= 1.0; receiver += 0.01)
    EXPECT_GE(visibilityOf(msm::Msm(), region, receiver),
              referenceVisibility(region, receiver) - 0.5 * 3e-5 - rounding);
}

// All texels at the near or far plane: the biased moments are those of two depths only.
TEST(Msm, SurvivesRegionsAtTheEndsOfDepth) {
  for (double z : {0.0, 1.0}) {
    const Region region = regionOf({z}, {1.0});
    for (double receiver : {0.0, 0.25, 0.5, 1.0})
      EXPECT_NEAR(visibilityOf(msm::Msm(), region, receiver), receiver <= z ? 1.0 : 0.0, 1.6e-5);
  }
}

TEST(Msm, QuantisationFillsTheRangeAndIsUndone) {
  Moments4 low{1, 1, 1, 1}, high{0, 0, 0, 0};
  for (int i = 0; i <= 1000; ++i) {
    const double z = i / 1000.0;
    const Moments4 stored = toQuantised(z), back = fromQuantised(stored);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(back[k], std::pow(z, k + 1), 1e-14);
      low[k] = std::min(low[k], stored[k]);
      high[k] = std::max(high[k], stored[k]);
    }
  }
  for (int k = 0; k < 4; ++k) {
    // An extreme lies within 1e-3 of a sampled x, and no channel bends more than 16 there:
    // 16/2·1e-6.
    EXPECT_NEAR(low[k], 0.0, 8e-6);
    EXPECT_NEAR(high[k], 1.0, 8e-6);
    EXPECT_GE(low[k], -1e-15);
    EXPECT_LE(high[k], 1.0 + 1e-15);
  }
}

TEST(Msm, NormalisedFormatsTurnQuantisationOn) {
  msm::Msm technique;
  EXPECT_TRUE(technique.limitTo(StorageFormat::Float).empty());
  EXPECT_EQ(technique.limitTo(StorageFormat::Unorm16).size(), 1u);
  EXPECT_EQ(technique.values.basis, msm::Basis::Quantised);
  const Region region = regionOf({0.2, 0.5, 0.7}, {0.25, 0.5, 0.25});
  const msm::Msm plain;
  for (double receiver : {0.3, 0.6, 0.8})
    EXPECT_NEAR(visibilityOf(technique, region, receiver), visibilityOf(plain, region, receiver),
                rounding);
}

}  // namespace
}  // namespace umbra
