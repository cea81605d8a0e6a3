// Regions that are given by their depths, for the tests of techniques.
#pragma once

#include <vector>

#include "filters/core/prefilter/Prefilter.h"

namespace umbra::test {

// A region of these depths with these weights, which sum to 1; equal ones where `weights` is empty.
inline Region regionOf(const std::vector<double>& depths, std::vector<double> weights = {}) {
  if (weights.empty()) weights.assign(depths.size(), 1.0 / double(depths.size()));
  Region region;
  for (std::size_t i = 0; i < depths.size(); ++i)
    region.texels.push_back({int(i), 0, depths[i], weights[i]});
  region.nearestDepth = depths.front();
  return region;
}

// The visibility by a technique whose channels are reduced over the region in double.
inline double visibilityOf(const Technique& technique, const Region& region, double receiver) {
  const std::vector<double> channels = prefilteredRegion(region, technique, StorageFormat::Double);
  return technique.visibility({channels, region}, receiver);
}

}  // namespace umbra::test
