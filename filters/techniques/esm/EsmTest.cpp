#include "filters/techniques/esm/Esm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "filters/core/prefilter/TestRegions.h"

namespace umbra {
namespace {

using test::visibilityOf;

Region twoDepths(double a, double b, double shareOfB) {
  return test::regionOf({a, b}, {1.0 - shareOfB, shareOfB});
}

// Behind a single depth the estimate is e^{−c·distance}.
TEST(Esm, FallsOffExponentiallyBehindOneDepth) {
  esm::Esm technique;
  technique.values.exponent = 20.0;
  const Region region = twoDepths(0.4, 0.4, 0.5);
  for (double distance : {0.01, 0.05, 0.2})
    EXPECT_NEAR(visibilityOf(technique, region, 0.4 + distance), std::exp(-20.0 * distance), 1e-13);
  EXPECT_EQ(visibilityOf(technique, region, 0.39), 1.0);
}

// On the farther of two planes the estimate is the share p, but for the nearer plane's own tail.
TEST(Esm, AddsTheOccludersTailToTheShareOfAPlanarReceiver) {
  const esm::Esm technique;
  const double p = 0.25, a = 0.5, b = 0.55;
  EXPECT_NEAR(visibilityOf(technique, twoDepths(a, b, p), b),
              p + (1 - p) * std::exp(-80.0 * (b - a)), 1e-13);
}

// The page's example: a tenth of the region, 0.03 behind the receiver, lights all of it.
TEST(Esm, OneDistantTexelLightsTheRegion) {
  EXPECT_EQ(visibilityOf(esm::Esm(), twoDepths(0.1, 0.63, 0.1), 0.6), 1.0);
}

TEST(Esm, HalfFloatsLimitTheExponent) {
  esm::Esm technique;
  EXPECT_TRUE(technique.limitTo(StorageFormat::Float).empty());
  const auto notes = technique.limitTo(StorageFormat::Half);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "esm.exponent 80 is beyond what half floats hold; 22 is used");
  double channel = 0.0;
  technique.encode(1.0, {&channel, 1});
  EXPECT_LT(channel, largestOf(StorageFormat::Half));
  technique.values.exponent = 300.0;
  technique.limitTo(StorageFormat::Float);
  technique.encode(1.0, {&channel, 1});
  EXPECT_LT(channel, largestOf(StorageFormat::Float));
}

TEST(Esm, RefusesNormalisedFormats) {
  EXPECT_FALSE(esm::Esm().refusal(StorageFormat::Unorm16).empty());
  EXPECT_TRUE(esm::Esm().refusal(StorageFormat::Half).empty());
}

}  // namespace
}  // namespace umbra
