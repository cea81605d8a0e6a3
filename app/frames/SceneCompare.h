// Techniques against the reference over all pixels of a frame.
#pragma once

#include "app/display/Display.h"
#include "app/frames/RayTracedFrame.h"
#include "app/reports/Reports.h"

namespace umbra {

// Compares over every pixel that receives shadow in the frame that was last rendered, with
// `technique`. Renders it again without light-bleeding reduction where the technique has one set.
// Where `rays` is given, it is the reference, and only pixels that have one count.
MetricsRow compareFrame(HeadlessFrame& frame, const Technique& technique,
                        const RayTracedReference* rays = nullptr);

}  // namespace umbra
