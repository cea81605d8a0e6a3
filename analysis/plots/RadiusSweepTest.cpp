#include "analysis/plots/RadiusSweep.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "analysis/probe/TestMaps.h"

namespace umbra {
namespace {

ProbeRequest requestOn(const DepthMap& map) {
  return {.map = map,
          .read = ReadPoint::atTexel(map, 20, 14),
          .kernel = {KernelShape::Box, 2},
          .receiver = 0.62,
          .techniques = everyTechnique(map)};
}

TEST(RadiusSweep, IsTheProbeOfEveryRadius) {
  const DepthMap map = randomMap(40, 30, 7);
  const RadiusSweep sweep = sweepRadius(requestOn(map), 6);
  ASSERT_EQ(sweep.radii.size(), 7u);
  for (int radius : {0, 2, 5}) {
    ProbeRequest request = requestOn(map);
    request.kernel.radius = radius;
    const Probe probe = takeProbe(request);
    EXPECT_EQ(sweep.radii[radius], radius);
    EXPECT_EQ(sweep.reference[radius], probe.reference);
    ASSERT_EQ(sweep.techniques.size(), probe.techniques.size());
    for (std::size_t i = 0; i < probe.techniques.size(); ++i)
      EXPECT_EQ(sweep.errors[i][radius], probe.techniques[i].error);
  }
}

TEST(RadiusSweep, PcfIsNeverWrongAndNoKernelCountsAsBox) {
  const DepthMap map = randomMap(40, 30, 8);
  ProbeRequest request = requestOn(map);
  const RadiusSweep box = sweepRadius(request, 4);
  request.kernel = {KernelShape::None, 2};
  const RadiusSweep none = sweepRadius(request, 4);
  EXPECT_EQ(none.errors, box.errors);
  for (std::size_t i = 0; i < box.techniques.size(); ++i) {
    if (box.techniques[i]->info().id != "pcf") continue;
    for (double error : box.errors[i]) EXPECT_EQ(error, 0.0);
  }
}

TEST(RadiusSweep, EndsWhereItsCallerEndsIt) {
  const DepthMap map = randomMap(40, 30, 9);
  int steps = 0;
  EXPECT_THROW(sweepRadius(requestOn(map), 10,
                           [&] {
                             if (++steps == 4) throw std::runtime_error("enough");
                           }),
               std::runtime_error);
  EXPECT_EQ(steps, 4);
}

TEST(RadiusSweep, PlotsTheSelectedTechniqueOnTop) {
  const DepthMap map = randomMap(40, 30, 7);
  const RadiusSweep sweep = sweepRadius(requestOn(map), 3);
  const Plot plot = radiusPlot(sweep, "esm", 2);
  ASSERT_EQ(plot.series.size(), sweep.techniques.size());
  EXPECT_EQ(plot.series.back().name, "ESM");
  EXPECT_GT(plot.series.back().lineWidth, plot.series.front().lineWidth);
  EXPECT_EQ(plot.markers.back().position, 2.0);
}

}  // namespace
}  // namespace umbra
