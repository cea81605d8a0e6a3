// Techniques against the reference over all pixels of a frame.
#pragma once

#include "analysis/Metrics.h"
#include "app/display/Display.h"

namespace umbra {

// Of the frame as it was last rendered, over every pixel that receives shadow.
Metrics metricsOf(HeadlessFrame& frame);

}  // namespace umbra
