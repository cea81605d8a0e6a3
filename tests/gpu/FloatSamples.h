// Second occluders as the GPU keeps them.
#pragma once

#include <vector>

#include "filters/core/settings/StorageFormat.h"
#include "filters/core/technique/Lloyd.h"

namespace umbra::test {

// Rounded to single precision: both sides then find every sample nearest to the same split, and
// their splits agree to what is left, the rounding of sums.
inline std::vector<WeightedSample> floatSamples(const DepthMap& map, WeightClamp clamp = {}) {
  std::vector<WeightedSample> samples = secondOccluderSamples(map, clamp);
  // Not by casts: GCC 12 leaves out the pair of them where it takes both values at once.
  for (WeightedSample& sample : samples) {
    sample.value = stored(sample.value, StorageFormat::Float);
    sample.weight = stored(sample.weight, StorageFormat::Float);
  }
  return samples;
}

}  // namespace umbra::test
