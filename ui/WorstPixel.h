// Where in a picture light bleeds most.
#pragma once

#include <optional>

#include "datasets/Session.h"
#include "filters/core/Image.h"

namespace umbra {

// `surfaces` and `reference` as ShadowRenderer gives them. The pixel about which the error of
// visibility, averaged over a few pixels, is largest: a spot that a person can see and hit, not a
// stray pixel. None where no spot bleeds visibly.
std::optional<Pixel> worstBleeding(const Image<float>& surfaces, const Image<float>& reference);

}  // namespace umbra
