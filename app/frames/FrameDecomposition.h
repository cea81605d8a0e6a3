// The error of a rendered frame, taken apart on every core.
#pragma once

#include <memory>
#include <optional>

#include "analysis/errors/ErrorDecomposition.h"
#include "app/display/Display.h"
#include "app/frames/RayTracedFrame.h"
#include "app/output/ChannelFile.h"

namespace umbra {

struct DecomposedFrame {
  ErrorDecomposition parts;  // of the error against exact percentage-closer filtering
  // The result of mapErrorsOf and its mean, where errors are against rays.
  std::optional<Image<double>> map;
  std::optional<double> meanOfMap;
};

// Decomposes the frame that was last rendered, with the technique of that frame; against `rays`
// where they are given, in the pixels that have one. Can be interrupted.
DecomposedFrame decomposeFrame(HeadlessFrame& frame, const RayTracedReference* rays = nullptr);

// A file with a channel for each part, under its name, 0 where no shadow falls; "receives" is 1
// where shadow falls. Against rays it also has "map", the error of the map itself.
ChannelFile decompositionFile(const Session& session, const Technique& technique,
                              const DecomposedFrame& decomposed);

}  // namespace umbra
