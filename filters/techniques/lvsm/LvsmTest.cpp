#include "filters/techniques/lvsm/Lvsm.h"

#include <gtest/gtest.h>

#include "filters/core/prefilter/TestRegions.h"
#include "filters/core/support/Error.h"
#include "filters/techniques/vsm/Vsm.h"

namespace umbra {
namespace {

using test::regionOf;
using test::visibilityOf;

void set(Technique& technique, std::string_view name, std::string_view text) {
  parameterNamed(technique.parameters(), name, "test").setFromText(text, "test");
}

TEST(Lvsm, WithOneLayerIsVsm) {
  lvsm::Lvsm technique;
  technique.values.layers = 1;
  const Region region = regionOf({0.1, 0.35, 0.4, 0.9, 0.9});
  for (double receiver = 0.0; receiver <= 1.0; receiver += 1.0 / 64.0)
    EXPECT_EQ(visibilityOf(technique, region, receiver),
              visibilityOf(vsm::Vsm(), region, receiver));
}

// Three planes (Lauritzen 2008, fig. 3.4): VSM bleeds on C, where all light is blocked.
TEST(Lvsm, ASplitBetweenTheSecondPlaneAndTheReceiverIsExact) {
  const double a = 0.2, b = 0.6, c = 0.75;
  const Region region = regionOf({a, b});
  EXPECT_GT(visibilityOf(vsm::Vsm(), region, c), 0.1);
  for (double split : {b, 0.65, 0.7}) {
    lvsm::Lvsm technique;
    technique.values.overlap = 0.0;
    set(technique, "splits", toText(std::vector<double>{split}));
    // In the far layer both occluders are at 0: no variance but the smallest one.
    const double width = 1.0 - split;
    const double smallest = 1e-6 / (width * width);
    const double warped = (c - split) / width;
    EXPECT_NEAR(visibilityOf(technique, region, c), smallest / (smallest + warped * warped), 1e-15);
  }
}

// §4.1.2: a split between A and B clamps their distance.
TEST(Lvsm, ASplitAboveTheSecondPlaneClampsTheBleeding) {
  const double a = 0.2, b = 0.6, c = 0.75, split = 0.5;
  lvsm::Lvsm technique;
  technique.values.overlap = 0.0;
  set(technique, "splits", "0.5");
  const double dx = b - split, dy = c - b;  // the split stands in for a
  EXPECT_NEAR(visibilityOf(technique, regionOf({a, b}), c),
              0.25 * dx * dx / (0.5 * dx * dx + dx * dy + dy * dy), 1e-12);
}

TEST(Lvsm, BlendsLinearlyAcrossASplit) {
  lvsm::Lvsm technique;
  technique.values.layers = 2;
  technique.values.overlap = 0.05;
  const Region region = regionOf({0.1, 0.3, 0.47, 0.6});
  const double smallStep = 1e-9;
  const double before = visibilityOf(technique, region, 0.45);
  EXPECT_NEAR(visibilityOf(technique, region, 0.45 + smallStep), before, 1e-6);
  const double after = visibilityOf(technique, region, 0.55);
  EXPECT_NEAR(visibilityOf(technique, region, 0.55 - smallStep), after, 1e-6);
  // Half way, each layer counts half. Layer 1 covers [0, 0.55], layer 2 [0.45, 1].
  const Layering layers = technique.layering();
  double halves = 0.0;
  for (int i = 0; i < 2; ++i) {
    double m1 = 0.0, m2 = 0.0;
    for (const RegionTexel& texel : region.texels) {
      m1 += texel.weight * layers.warp(i, texel.depth);
      m2 += texel.weight * layers.warp(i, texel.depth) * layers.warp(i, texel.depth);
    }
    const double t = layers.warp(i, 0.5), variance = m2 - m1 * m1;
    halves += t <= m1 ? 0.5 : 0.5 * variance / (variance + (t - m1) * (t - m1));
  }
  EXPECT_NEAR(visibilityOf(technique, region, 0.5), halves, 1e-12);
}

TEST(Lvsm, ManualSplitsBringTheirPlacementAndLayers) {
  lvsm::Lvsm technique;
  set(technique, "splits", "0.2:0.5:0.7:0.8");
  EXPECT_EQ(technique.values.placement, LayerPlacement::Manual);
  EXPECT_EQ(technique.channels().size(), 10u);
  EXPECT_EQ(technique.channels()[9].name, "L5M2");
  EXPECT_EQ(technique.layering().bounds[2], 0.5);
  set(technique, "placement", "uniform");
  EXPECT_TRUE(technique.values.splits.empty());
  EXPECT_EQ(technique.layering().bounds[1], 0.2);
}

TEST(Lvsm, RefusesSplitsThatDoNotRise) {
  lvsm::Lvsm technique;
  for (std::string_view wrong : {"0.5:0.2", "0.5:0.5", "0:0.5", "0.5:1"}) {
    try {
      set(technique, "splits", wrong);
      ADD_FAILURE() << wrong << " was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      EXPECT_NE(std::string(error.what()).find("lvsm.splits"), std::string::npos);
    }
  }
  EXPECT_TRUE(technique.values.splits.empty());
}

TEST(Lvsm, LloydSplitsFollowTheMap) {
  DepthMap map(16, 16, 1, 0.8);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 8; ++x) map(x, y) = 0.3;
  lvsm::Lvsm technique;
  technique.values.layers = 2;
  technique.values.placement = LayerPlacement::Lloyd;
  EXPECT_EQ(technique.layering().bounds[1], 0.5);  // no map yet
  technique.adapt(map);
  // One straight edge: two of four texels at either depth, so μ + σ is the farther depth.
  EXPECT_NEAR(technique.layering().bounds[1], 0.8, 1e-12);
  technique.values.layers = 3;
  EXPECT_EQ(technique.layering().bounds[1], 1.0 / 3.0);  // not adapted to this many
}

}  // namespace
}  // namespace umbra
