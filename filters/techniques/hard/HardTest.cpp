#include "filters/techniques/hard/Hard.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

TEST(Hard, ComparesTheNearestTexelOnly) {
  const hard::Hard technique;
  Region region;
  region.texels = {{0, 0, 0.1, 0.5}, {1, 0, 0.6, 0.5}};
  region.nearestDepth = 0.6;
  EXPECT_EQ(technique.visibility({{}, region}, 0.59), 1.0);
  EXPECT_EQ(technique.visibility({{}, region}, 0.61), 0.0);
}

TEST(Hard, IsLitAtEquality) {
  const hard::Hard technique;
  Region region;
  region.nearestDepth = 0.3;
  EXPECT_EQ(technique.visibility({{}, region}, 0.3), 1.0);
}

}  // namespace
}  // namespace umbra
