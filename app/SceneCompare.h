// Techniques against the reference over all pixels of a frame.
#pragma once

#include "app/Reports.h"
#include "app/display/Display.h"

namespace umbra {

// Of the frame as it was last rendered with `technique`, over every pixel that receives shadow.
// Renders it again without light-bleeding reduction where the technique has one set.
MetricsRow compareFrame(HeadlessFrame& frame, const Technique& technique);

}  // namespace umbra
