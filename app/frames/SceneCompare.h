// Techniques against the reference over all pixels of a frame.
#pragma once

#include "app/display/Display.h"
#include "app/frames/RayTracedFrame.h"
#include "app/reports/Reports.h"

namespace umbra {

// Of the frame as it was last rendered with `technique`, over every pixel that receives shadow.
// Renders it again without light-bleeding reduction where the technique has one set.
// Against `rays` where given, and then over the pixels that have one.
MetricsRow compareFrame(HeadlessFrame& frame, const Technique& technique,
                        const RayTracedReference* rays = nullptr);

}  // namespace umbra
