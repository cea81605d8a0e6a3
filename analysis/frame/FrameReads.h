// What the pixels of a drawn frame read.
#pragma once

#include <functional>
#include <vector>

#include "analysis/probe/Probe.h"
#include "filters/core/frame/FrameSnapshot.h"

namespace umbra {

// Gives a cascade's map; it is called only for maps that are read.
using MapOf = std::function<const DepthMap&(int cascade)>;
// A request for a read in a frame that was drawn with `settings`, in its format, without
// techniques. It refers to the maps.
ProbeRequest requestOf(const FrameSettings& settings, const std::vector<Cascade>& cascades,
                       const MapOf& mapOf, const SurfacePoint& surface);
// The same in the frame of a snapshot; it refers to the snapshot's maps.
ProbeRequest requestOf(const FrameSnapshot& frame, const SurfacePoint& surface);
// The request for a pixel that shows a surface.
ProbeRequest requestAt(const FrameSnapshot& frame, int x, int y);

// Roughly how many taps are read by the pixels for which `counts` is true: judged by every
// sixteenth pixel along both axes.
double tapsOf(const FrameSnapshot& frame, const std::function<bool(int x, int y)>& counts);
// The smallest stride s ≥ 1 at which every s-th pixel of every s-th row reads at most `most` taps
// in all, in a frame whose pixels read `taps`.
int strideFor(double taps, double most);

}  // namespace umbra
