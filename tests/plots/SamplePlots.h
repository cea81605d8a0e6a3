// Plots of a real probe, for the tests of their drawing.
#pragma once

#include <random>

#include "analysis/plots/ProbePlots.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {

// Leaves over a bench, as in Lauritzen 2008, fig. 3.5: light bleeds onto the ground beneath both.
inline DepthMap leavesOverBench() {
  DepthMap map(32, 32);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.012);
  for (double& depth : map.values()) depth = (random() % 100 < 40 ? 0.31 : 0.625) + noise(random);
  return map;
}

inline Probe sampleProbe(const DepthMap& map, double receiver = 0.78) {
  ProbeRequest request{.map = map,
                       .read = ReadPoint::atTexel(map, 16, 16),
                       .kernel = {KernelShape::Box, 5},
                       .receiver = receiver};
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* technique : catalogue.all()) {
    std::shared_ptr<Technique> copy = technique->clone();
    copy->adapt(map);
    request.techniques.push_back(std::move(copy));
  }
  return takeProbe(request);
}

}  // namespace umbra
