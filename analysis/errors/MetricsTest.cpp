#include "analysis/errors/Metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbra {
namespace {

TEST(Metrics, OfNothingAreZero) {
  const Metrics m = MetricsSum().result();
  EXPECT_EQ(m.samples, 0u);
  for (double value : {m.rmse, m.mae, m.bleeding, m.darkening, m.max, m.min, m.umbraBleeding})
    EXPECT_EQ(value, 0.0);
}

// Binary fractions, so that every expectation is exact.
TEST(Metrics, FollowTheirDefinitions) {
  MetricsSum sum;
  sum.add(0.5, 0.0);   // +0.5, umbra
  sum.add(0.25, 0.5);  // −0.25
  sum.add(1.0, 1.0);   // 0
  sum.add(0.0, 0.0);   // 0, umbra
  const Metrics m = sum.result();
  EXPECT_EQ(m.samples, 4u);
  EXPECT_EQ(m.rmse, std::sqrt((0.25 + 0.0625) / 4));
  EXPECT_EQ(m.mae, 0.1875);
  EXPECT_EQ(m.bleeding, 0.125);
  EXPECT_EQ(m.darkening, 0.0625);
  EXPECT_EQ(m.max, 0.5);
  EXPECT_EQ(m.min, -0.25);
  EXPECT_EQ(m.umbraBleeding, 0.25);
}

TEST(Metrics, ExtremesNeedNotStraddleZero) {
  MetricsSum over, under;
  over.add(0.75, 0.5);
  over.add(1.0, 0.5);
  under.add(0.25, 0.5);
  EXPECT_EQ(over.result().min, 0.25);
  EXPECT_EQ(over.result().max, 0.5);
  EXPECT_EQ(under.result().max, -0.25);
}

TEST(Metrics, UmbraNeedsAReferenceOfExactlyZero) {
  MetricsSum sum;
  sum.add(0.5, 1e-9);
  EXPECT_EQ(sum.result().umbraBleeding, 0.0);
}

}  // namespace
}  // namespace umbra
