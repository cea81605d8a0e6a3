// The error of a rendered frame, taken apart on every core.
#pragma once

#include <memory>

#include "analysis/errors/ErrorDecomposition.h"
#include "app/display/Display.h"
#include "app/output/ChannelFile.h"

namespace umbra {

// Decomposes the frame that was last rendered, with the technique of that frame. Can be
// interrupted.
ErrorDecomposition decomposeFrame(HeadlessFrame& frame, const DecompositionSettings& how = {});

// A file with a channel for each part, under its name, 0 where no shadow falls; "receives" is 1
// where shadow falls.
ChannelFile decompositionFile(const Session& session, const Technique& technique,
                              const ErrorDecomposition& decomposition);

}  // namespace umbra
