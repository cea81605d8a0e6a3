// The ray-traced reference of a rendered frame.
#pragma once

#include <memory>

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

// The rays through the maps of a frame, for many reads of it.
std::unique_ptr<RayTracedVisibility> raysFor(const FrameSnapshot& frame);

// The reference of every pixel of the last frame, computed on every core; can be interrupted.
RayTracedReference rayTracedReference(HeadlessFrame& frame);

// The ray-traced reference of one probe of the last frame.
double rayTracedVisibility(HeadlessFrame& frame, const Probe& probe);

}  // namespace umbra
