// What the shaded frame reads for a pixel.
#pragma once

#include "analysis/Probe.h"
#include "app/display/Display.h"

namespace umbra {

// A pixel that receives shadow, without its place in the world. `surfaces` are the last frame's: a
// point or bilinear read of the only map is known from them; every other one needs the pixel's
// footprint or cascade, which is read back for it alone.
SurfacePoint surfaceAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const Image<float>& surfaces, int x, int y);

// The read of the last frame at `surface`, in the session's format, without techniques. Refers to
// the frame's depth maps: it is valid until the frame is rendered with another map.
ProbeRequest requestAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const SurfacePoint& surface);

}  // namespace umbra
