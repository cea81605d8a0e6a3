// Techniques against the reference over a whole depth map.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "analysis/errors/Metrics.h"
#include "filters/core/maps/Image.h"
#include "filters/core/settings/Kernel.h"
#include "filters/core/settings/StorageFormat.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// Σ w [z ≥ receiver] at every texel, over the kernel's window: the reference of a point read, with
// a receiver plane at depth `receiver`. One channel in [0,1], exactly 0 where every texel blocks.
Image<double> referenceMap(const DepthMap& map, const Kernel& kernel, double receiver);

// The metrics of every technique (parameters set, adapted to the map), in their order, over all
// texels: point reads of the prefiltered map, a receiver plane at depth `receiver`. `eachRow` is
// called between rows of texels; what it throws ends the comparison.
//
// The cost per texel does not grow with a box kernel's radius, but where the answer of a technique
// that is not prefilterable depends on the region's taps, as in a penumbra: there it grows with
// the square.
std::vector<Metrics> compareOnMap(
    const DepthMap& map, std::span<const std::shared_ptr<const Technique>> techniques,
    const Kernel& kernel, StorageFormat format, double receiver,
    const std::function<void()>& eachRow = [] {});

}  // namespace umbra
