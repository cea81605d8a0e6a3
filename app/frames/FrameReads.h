// The reads of the pixels of a headless frame.
#pragma once

#include "analysis/frame/DrawnFrame.h"
#include "app/display/Display.h"

namespace umbra {

// The last frame, which was drawn with `settings`. It refers to the frame's depth maps, so that it
// is valid only until the frame is rendered with other settings.
DrawnFrame drawnFrame(HeadlessFrame& frame, const FrameSettings& settings);

// The read of the last frame at `surface`, in the session's format, without techniques. It is valid
// as long.
ProbeRequest requestAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const SurfacePoint& surface);

}  // namespace umbra
