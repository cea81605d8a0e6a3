// The ray-traced truth of a rendered frame.
#pragma once

#include "analysis/probe/Probe.h"
#include "analysis/rays/RayTracedVisibility.h"
#include "app/display/Display.h"

namespace umbra {

// Ray-traced visibility of a frame's pixels. Of a frame that reads very many taps only every
// `stride`-th pixel of every `stride`-th row has one.
struct RayTracedReference {
  static constexpr float absent = -1.0f;

  Image<float> visibility;  // `absent` where no shadow is received or the pixel is left out
  int stride = 1;
};

// The rays through a map of the last frame, n of every texel's side.
RayTracedVisibility lightRays(HeadlessFrame& frame, const Scene& scene,
                              const FrameSettings& settings, int side);

// Of every pixel of the last frame, on every core; can be interrupted.
RayTracedReference rayTracedReference(HeadlessFrame& frame, const Scene& scene,
                                      const FrameSettings& settings);

// Of one probe of the last frame.
double rayTracedVisibility(HeadlessFrame& frame, const Scene& scene, const FrameSettings& settings,
                           const Probe& probe);

}  // namespace umbra
