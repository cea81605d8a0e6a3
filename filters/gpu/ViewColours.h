// The colour maps of the view modes, for legends beside the picture: the same numbers that the
// shaders get. Components in [0,1].
#pragma once

#include <array>

#include "filters/core/support/ErrorColours.h"

namespace umbra {

// The colours of layers, from the light outwards, in turn: neighbours differ in hue and lightness.
inline constexpr std::array<ViewColour, 8> layerColours{{{0.99f, 0.86f, 0.55f},
                                                         {0.45f, 0.68f, 0.82f},
                                                         {0.93f, 0.66f, 0.51f},
                                                         {0.56f, 0.78f, 0.60f},
                                                         {0.80f, 0.66f, 0.84f},
                                                         {0.86f, 0.84f, 0.70f},
                                                         {0.48f, 0.60f, 0.72f},
                                                         {0.90f, 0.74f, 0.80f}}};

// The colours of cascades, from the camera outwards.
inline constexpr std::array<ViewColour, 4> cascadeColours{
    {{0.98f, 0.80f, 0.36f}, {0.47f, 0.76f, 0.52f}, {0.42f, 0.63f, 0.87f}, {0.74f, 0.55f, 0.82f}}};

// Receiver depth z_r in [0,1]: near the light is bright, as in a picture of the shadow map.
inline ViewColour colourOfDepth(double z) {
  const float grey = float(1.0 - std::clamp(z, 0.0, 1.0));
  return {grey, grey, grey};
}

}  // namespace umbra
