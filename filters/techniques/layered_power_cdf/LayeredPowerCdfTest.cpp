#include "filters/techniques/layered_power_cdf/LayeredPowerCdf.h"

#include <gtest/gtest.h>

#include "filters/core/prefilter/TestRegions.h"
#include "filters/techniques/power_cdf/PowerCdf.h"

namespace umbra {
namespace {

using test::regionOf;
using test::visibilityOf;

TEST(LayeredPowerCdf, WithOneLayerIsThePowerCdf) {
  layered_power_cdf::LayeredPowerCdf technique;
  technique.values.layers = 1;
  const Region region = regionOf({0.1, 0.35, 0.4, 0.9, 0.9});
  for (double receiver = 0.0; receiver <= 1.0; receiver += 1.0 / 64.0)
    EXPECT_EQ(visibilityOf(technique, region, receiver),
              visibilityOf(power_cdf::PowerCdf(), region, receiver));
}

// The fit in one layer does not change when depths in another do.
TEST(LayeredPowerCdf, SeesOnlyItsOwnLayer) {
  layered_power_cdf::LayeredPowerCdf technique;
  technique.values.layers = 2;
  technique.values.overlap = 0.0;
  const Region near = regionOf({0.1, 0.6, 0.7, 0.9}), far = regionOf({0.5, 0.6, 0.7, 0.9});
  for (double receiver : {0.55, 0.7, 0.8}) {
    EXPECT_EQ(visibilityOf(technique, near, receiver), visibilityOf(technique, far, receiver));
    EXPECT_NEAR(visibilityOf(technique, near, receiver),
                visibilityOf(power_cdf::PowerCdf(), far, receiver), 1e-13);
  }
}

TEST(LayeredPowerCdf, NamesThreeChannelsALayer) {
  layered_power_cdf::LayeredPowerCdf technique;
  const auto channels = technique.channels();
  ASSERT_EQ(channels.size(), 12u);
  EXPECT_EQ(channels[3].name, "L2mean");
  EXPECT_EQ(channels[4].reduction, Reduction::Min);
  EXPECT_EQ(channels[11].name, "L4max");
  EXPECT_EQ(channels[11].reduction, Reduction::Max);
}

}  // namespace
}  // namespace umbra
