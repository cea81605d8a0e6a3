// Where in a picture light bleeds most.
#pragma once

#include <optional>

#include "filters/core/maps/Image.h"

namespace umbra {

// A pixel of a picture; x to the right, y down, from 0.
struct PicturePixel {
  int x = 0, y = 0;
};

// `surfaces` and `reference` as ShadowRenderer gives them. The worst pixel of the spot with the
// largest mean error of visibility among those that are fully in shadow and on one smooth surface:
// light that bleeds where a person can see it and point at it, not a stray pixel of a leaf. Where
// there is no such spot, of those that are smooth only. None where no spot bleeds visibly.
std::optional<PicturePixel> worstBleeding(const Image<float>& surfaces,
                                          const Image<float>& reference);

}  // namespace umbra
