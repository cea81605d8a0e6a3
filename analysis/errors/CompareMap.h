// Techniques against the reference over a whole depth map.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "analysis/errors/BleedReduction.h"
#include "analysis/errors/Metrics.h"
#include "filters/core/maps/Image.h"
#include "filters/core/settings/Kernel.h"
#include "filters/core/settings/StorageFormat.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// Σ w [z ≥ receiver] at every texel, over the kernel's window: the reference of a point read, with
// a receiver plane at depth `receiver`. One channel in [0,1], exactly 0 where every texel blocks.
Image<double> referenceMap(const DepthMap& map, const Kernel& kernel, double receiver);

struct MapFigures {
  Metrics metrics;
  // The smallest bleed reduction, whatever it is set to; nothing for a technique without one.
  std::optional<BleedReduction> reduction;
};

// The figures of every technique (parameters set, adapted to the map), in their order, over all
// texels: point reads of the prefiltered map, a receiver plane at depth `receiver`. The map is
// walked in strips of rows on every core, each strip as one whatever the number of cores, so that
// the figures are the same bits. The calling thread calls `between` strips; what it throws ends the
// comparison.
//
// The cost per texel does not grow with a box kernel's radius, but where the answer of a technique
// that is not prefilterable depends on the region's taps, as in a penumbra: there it grows with the
// square. The memory beyond the map is 8 bytes a texel, what strips need, and 16 bytes for each
// receiver that a reduction may darken.
std::vector<MapFigures> figuresOnMap(
    const DepthMap& map, std::span<const std::shared_ptr<const Technique>> techniques,
    const Kernel& kernel, StorageFormat format, double receiver,
    const std::function<void()>& between = [] {});

// The metrics alone.
std::vector<Metrics> compareOnMap(
    const DepthMap& map, std::span<const std::shared_ptr<const Technique>> techniques,
    const Kernel& kernel, StorageFormat format, double receiver,
    const std::function<void()>& between = [] {});

}  // namespace umbra
