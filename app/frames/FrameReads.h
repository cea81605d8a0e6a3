// What the pixels of a headless frame read.
#pragma once

#include "analysis/frame/DrawnFrame.h"
#include "app/display/Display.h"

namespace umbra {

// The last frame, drawn with `settings`. Refers to the frame's depth maps: it is valid until the
// frame is rendered with others.
DrawnFrame drawnFrame(HeadlessFrame& frame, const FrameSettings& settings);

// The read of the last frame at `surface`, in the session's format, without techniques; as valid.
ProbeRequest requestAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const SurfacePoint& surface);

}  // namespace umbra
