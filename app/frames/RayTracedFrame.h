// The ray-traced reference of a rendered frame.
#pragma once

#include "analysis/probe/Probe.h"
#include "analysis/rays/RayTracedVisibility.h"
#include "app/display/Display.h"

namespace umbra {

// The ray-traced reference of a frame's pixels. In a frame that reads very many taps, only every
// `stride`-th pixel of every `stride`-th row has one.
struct RayTracedReference {
  Image<float> visibility;  // noReference where no shadow is received or the pixel is left out
  int stride = 1;
};

// The rays through the maps of the last frame, `side` × `side` in every texel.
RayTracedVisibility lightRays(HeadlessFrame& frame, const Scene& scene,
                              const FrameSettings& settings, int side);

// The reference of every pixel of the last frame, computed on every core; can be interrupted.
RayTracedReference rayTracedReference(HeadlessFrame& frame, const Scene& scene,
                                      const FrameSettings& settings);

// The ray-traced reference of one probe of the last frame.
double rayTracedVisibility(HeadlessFrame& frame, const Scene& scene, const FrameSettings& settings,
                           const Probe& probe);

}  // namespace umbra
