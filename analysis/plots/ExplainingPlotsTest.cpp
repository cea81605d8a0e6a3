#include "analysis/plots/ExplainingPlots.h"

#include <gtest/gtest.h>

#include <set>

#include "analysis/probe/TestMaps.h"

namespace umbra {
namespace {

ProbeRequest requestOn(const DepthMap& map, double receiver) {
  return {.map = map,
          .read = ReadPoint::atTexel(map, 6, 6),
          .kernel = {KernelShape::Box, 1},
          .receiver = receiver,
          .techniques = everyTechnique(map)};
}

TEST(ExplainingPlots, EveryOneIsMadeAndIsCalledByItsName) {
  // A over B over C: columns of two planes, and a receiver behind both.
  DepthMap map(12, 12, 1, 0.7);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; x += 3) map(x, y) = 0.2;
  const ProbeRequest request = requestOn(map, 0.9);
  const Probe probe = takeProbe(request);
  std::set<std::string_view> names;
  for (const ExplainingPlot& each : explainingPlots()) {
    const auto plot = explainingPlot(each.name, {request, probe, "vsm", {0.2, 0.7, 0.9}});
    ASSERT_TRUE(plot) << each.name;
    EXPECT_EQ(plot->name, each.name);
    EXPECT_FALSE(plot->series.empty()) << each.name;
    EXPECT_FALSE(plot->title.empty() || plot->xLabel.empty() || plot->yLabel.empty()) << each.name;
    for (const PlotSeries& series : plot->series)
      EXPECT_EQ(series.x.size(), series.y.size() + (series.style == SeriesStyle::Bars ? 1 : 0))
          << each.name << ": " << series.name;
    EXPECT_NO_THROW(toCsv(*plot));
    EXPECT_TRUE(names.insert(each.name).second);
  }
  EXPECT_EQ(names.size(), 11u);
}

TEST(ExplainingPlots, WhatHasNothingToShowIsNone) {
  const DepthMap map(12, 12, 1, 0.7);
  const ProbeRequest request = requestOn(map, 0.5);
  const Probe probe = takeProbe(request);
  EXPECT_FALSE(explainingPlot("distance", {request, probe, "vsm", {}}));
  EXPECT_FALSE(explainingPlot("planes", {request, probe, "vsm", {}}));
  EXPECT_FALSE(explainingPlot("coverage", {request, probe, "vsm", {0.3, 0.9}}));
  EXPECT_FALSE(explainingPlot("precision", {request, probe, "none", {}}));
  EXPECT_FALSE(explainingPlot("nothing", {request, probe, "vsm", {}}));
  EXPECT_TRUE(explainingPlot("planes", {request, probe, "vsm", {0.3, 0.7}}));
}

TEST(ExplainingPlots, ASlowOneCanBeEnded) {
  const DepthMap map(12, 12, 1, 0.7);
  const ProbeRequest request = requestOn(map, 0.5);
  const Probe probe = takeProbe(request);
  EXPECT_THROW(explainingPlot("radius", {request, probe, "vsm", {}},
                              [] { throw std::runtime_error("enough"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace umbra
