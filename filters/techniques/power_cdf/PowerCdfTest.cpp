#include "filters/techniques/power_cdf/PowerCdf.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbra {
namespace {

double visibilityOf(double mean, double min, double max, double receiver) {
  const std::vector<double> channels{mean, min, max};
  return power_cdf::PowerCdf().visibility({channels, Region{}}, receiver);
}

// Gumbau 2011, eq. 4, where the plain formula is harmless.
TEST(PowerCdf, FollowsEquation4) {
  const double min = 0.2, max = 0.7;
  for (double beta : {0.5, 1.0, 2.0, 5.0}) {
    const double mean = min + (max - min) * beta / (beta + 1.0);
    for (double t : {0.1, 0.4, 0.6, 0.8, 0.85, 0.9, 0.99}) {
      const double expected =
          t <= beta / (beta + 1.0)
              ? 1.0
              : (1.0 - std::pow(t, beta)) / (1.0 - std::pow(beta / (beta + 1.0), beta));
      EXPECT_NEAR(visibilityOf(mean, min, max, min + t * (max - min)), expected, 1e-13)
          << "beta " << beta << ", t " << t;
    }
  }
}

TEST(PowerCdf, IsDarkFromTheMaximumOn) {
  EXPECT_EQ(visibilityOf(0.4, 0.2, 0.7, 0.7), 0.0);
  EXPECT_EQ(visibilityOf(0.4, 0.2, 0.7, 0.9), 0.0);
}

TEST(PowerCdf, IsTheHardTestWhereAllDepthsAreEqual) {
  EXPECT_EQ(visibilityOf(0.4, 0.4, 0.4, 0.4), 1.0);
  EXPECT_EQ(visibilityOf(0.4, 0.4, 0.4, 0.41), 0.0);
  // A mean that rounding moved outside changes nothing.
  EXPECT_EQ(visibilityOf(0.4 - 1e-16, 0.4, 0.4, 0.4), 1.0);
  EXPECT_EQ(visibilityOf(0.4 + 1e-9, 0.4, 0.4, 0.4 + 1e-10), 0.0);
}

TEST(PowerCdf, HasItsLimitsAtBothEndsOfBeta) {
  // β = 0: dark behind the mean, lit up to it.
  EXPECT_EQ(visibilityOf(0.2, 0.2, 0.7, 0.2), 1.0);
  EXPECT_EQ(visibilityOf(0.2, 0.2, 0.7, 0.2001), 0.0);
  // β infinite: the mean is the maximum.
  EXPECT_EQ(visibilityOf(0.7, 0.2, 0.7, 0.7), 1.0);
  EXPECT_EQ(visibilityOf(0.7, 0.2, 0.7, 0.7001), 0.0);
  // As β grows, t^β with 1 − t = x·(1 − t̄) goes to e^{−x}: v goes to (1 − e^{−x})/(1 − e^{−1}),
  // with an error of the order 1/β.
  const double gap = 0.5e-9;
  for (double x : {0.25, 0.5, 0.75})
    EXPECT_NEAR(visibilityOf(0.7 - gap, 0.2, 0.7, 0.7 - x * gap),
                (1.0 - std::exp(-x)) / (1.0 - std::exp(-1.0)), 1e-6);
}

}  // namespace
}  // namespace umbra
