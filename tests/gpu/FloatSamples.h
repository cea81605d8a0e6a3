// Second occluders as the GPU keeps them.
#pragma once

#include <vector>

#include "filters/core/settings/StorageFormat.h"
#include "filters/core/technique/Lloyd.h"

namespace umbra::test {

// Samples rounded to single precision: both sides then find every sample nearest to the same split,
// and their splits differ only by the rounding of sums.
inline std::vector<WeightedSample> floatSamples(const DepthMap& map, WeightClamp clamp = {}) {
  std::vector<WeightedSample> samples = secondOccluderSamples(map, clamp);
  // The values are not rounded by casts: GCC 12 leaves a pair of casts out where it takes both
  // values at once.
  for (WeightedSample& sample : samples) {
    sample.value = stored(sample.value, StorageFormat::Float);
    sample.weight = stored(sample.weight, StorageFormat::Float);
  }
  return samples;
}

}  // namespace umbra::test
