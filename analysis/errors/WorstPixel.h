// Where in a picture light bleeds most.
#pragma once

#include <optional>

#include "filters/core/maps/Image.h"
#include "filters/core/maps/SurfaceImage.h"

namespace umbra {

// A pixel of a picture; x to the right, y down, from 0.
struct PicturePixel {
  int x = 0, y = 0;
};

// Finds the spot with the largest mean error among those that are fully in shadow and on one smooth
// surface, and in it the worst pixel. This is light that bleeds where a person can see it and point
// at it, not a stray pixel of a leaf. Where there is no such spot, one that is only smooth is
// taken. Nothing where no spot bleeds so that anybody sees it. `reference` is that of
// ShadowRenderer.
std::optional<PicturePixel> worstBleeding(const SurfaceImage& surfaces,
                                          const Image<float>& reference);

}  // namespace umbra
