// The error of a rendered frame, taken apart on every core.
#pragma once

#include <memory>

#include "analysis/ErrorDecomposition.h"
#include "app/display/Display.h"

namespace umbra {

// Of the frame as it was last rendered with `technique` and `settings`. Can be interrupted.
ErrorDecomposition decomposeFrame(HeadlessFrame& frame, const FrameSettings& settings,
                                  const Technique& technique,
                                  const DecompositionSettings& how = {});

}  // namespace umbra
