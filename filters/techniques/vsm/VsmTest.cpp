#include "filters/techniques/vsm/Vsm.h"

#include <gtest/gtest.h>

#include "filters/core/prefilter/Prefilter.h"

namespace umbra {
namespace {

// Lauritzen 2008, §3.2: planar occluder at d1, planar receiver at d2, share p unoccluded.
TEST(Vsm, IsExactForOneOccluderOverAPlane) {
  const vsm::Vsm technique;
  const double d1 = 0.3, d2 = 0.8;
  for (double p : {0.1, 0.25, 0.5, 0.9}) {
    const std::vector<double> moments{p * d2 + (1 - p) * d1, p * d2 * d2 + (1 - p) * d1 * d1};
    EXPECT_NEAR(technique.visibility({moments, Region{}}, d2), p, 1e-12);
  }
}

// Lauritzen 2008, eq. 3.4.
TEST(Vsm, BleedsByTheClosedFormOfThreePlanes) {
  const vsm::Vsm technique;
  const double a = 0.2, b = 0.6, c = 0.75;
  const std::vector<double> moments{(a + b) / 2, (a * a + b * b) / 2};
  const double dx = b - a, dy = c - b;
  const double expected = 0.25 * dx * dx / (0.5 * dx * dx + dx * dy + dy * dy);
  EXPECT_NEAR(technique.visibility({moments, Region{}}, c), expected, 1e-12);
}

TEST(Vsm, ReductionStretchesWhatIsAboveIt) {
  vsm::Vsm technique;
  technique.values.bleedReduction = 0.2;
  const std::vector<double> moments{0.5, 0.5 * 0.5 + 0.01};
  EXPECT_NEAR(technique.visibility({moments, Region{}}, 0.6), (0.5 - 0.2) / 0.8, 1e-12);
  EXPECT_EQ(technique.visibility({moments, Region{}}, 0.9), 0.0);
  EXPECT_EQ(technique.visibility({moments, Region{}}, 0.5), 1.0);
}

}  // namespace
}  // namespace umbra
