#include "filters/techniques/pcf/Pcf.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

TEST(Pcf, AddsTheWeightsOfTheTexelsThatDoNotBlock) {
  const pcf::Pcf technique;
  Region region;
  region.texels = {{0, 0, 0.2, 0.125}, {1, 0, 0.5, 0.25}, {2, 0, 0.9, 0.625}};
  EXPECT_EQ(technique.visibility({{}, region}, 0.1), 1.0);
  EXPECT_EQ(technique.visibility({{}, region}, 0.3), 0.875);
  EXPECT_EQ(technique.visibility({{}, region}, 0.5), 0.875);  // equality is lit
  EXPECT_EQ(technique.visibility({{}, region}, 0.6), 0.625);
  EXPECT_EQ(technique.visibility({{}, region}, 1.0), 0.0);
}

}  // namespace
}  // namespace umbra
