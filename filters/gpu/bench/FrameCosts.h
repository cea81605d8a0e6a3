// What frames of a renderer cost, beside what they show.
#pragma once

#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"
#include "filters/gpu/ShadowRenderer.h"

namespace umbra {

// Milliseconds of one frame whose bake is done anew.
struct FrameCosts {
  double bakeMs = 0.0;   // depths, splits, channels and what is made of them
  double shadeMs = 0.0;  // the shaded scene, and the picture's way to the window
};

// Medians of a few frames as the renderer is set up, after one that compiles shaders: three, or
// fewer where they take more than a second. On the clock that fits the renderer, whose context is
// current.
FrameCosts costOfFrames(ShadowRenderer& renderer);

// The bytes of all textures that the settings take on the GPU, by texels of the shadow map: see
// textureBytes.
double bytesUsedPerTexel(const FrameSettings& settings, const Technique& technique);

}  // namespace umbra
