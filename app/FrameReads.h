// What the shaded frame reads for a pixel.
#pragma once

#include "analysis/Probe.h"
#include "app/display/Display.h"

namespace umbra {

// The read of the last frame at `surface`, in the session's format, without techniques. Refers to
// the frame's depth maps: it is valid until the frame is rendered with another map.
ProbeRequest requestAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const SurfacePoint& surface);

}  // namespace umbra
