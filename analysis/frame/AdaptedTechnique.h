// A technique as it is in a frame: with the splits that hold there.
#pragma once

#include <memory>
#include <span>

#include "filters/core/technique/Technique.h"

namespace umbra {

// A copy whose splits, where they follow the map, are those that the frame was drawn with, so that
// figures and picture agree to the last digit also while splits move; `drawn` is empty where the
// frame was drawn with another technique, or none was. They are found in `map` then, the first
// cascade's, as the frame would find them at rest.
std::shared_ptr<const Technique> adaptedTechnique(const Technique& technique, const DepthMap& map,
                                                  std::span<const double> drawn = {});

}  // namespace umbra
