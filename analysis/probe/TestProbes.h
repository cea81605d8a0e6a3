// Probes of regions that are given by their depths, for the tests of the analysis.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "analysis/probe/Probe.h"
#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {

// A region of depths with these weights, which sum to 1; equal ones where `weights` is empty.
inline Probe probeOfDepths(const std::vector<double>& depths, double receiver,
                           std::vector<double> weights = {}) {
  Probe probe;
  if (weights.empty()) weights.assign(depths.size(), 1.0 / double(depths.size()));
  for (std::size_t i = 0; i < depths.size(); ++i)
    probe.region.texels.push_back({0, 0, depths[i], weights[i]});
  probe.receiver = receiver;
  probe.statistics = statisticsOf(probe.region);
  probe.reference = referenceVisibility(probe.region, receiver);
  return probe;
}

inline void addResult(Probe& probe, std::shared_ptr<const Technique> technique,
                      StorageFormat format = StorageFormat::Double) {
  TechniqueResult result;
  result.channels = prefilteredRegion(probe.region, *technique, format);
  result.visibility = technique->visibility({result.channels, probe.region}, probe.receiver);
  result.error = result.visibility - probe.reference;
  result.technique = std::move(technique);
  probe.techniques.push_back(std::move(result));
}

}  // namespace umbra
