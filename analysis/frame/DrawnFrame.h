// A drawn frame as plain data, from which any thread can tell what each pixel read, without OpenGL.
#pragma once

#include <functional>
#include <vector>

#include "analysis/probe/Probe.h"
#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Image.h"
#include "filters/core/maps/SurfaceImage.h"
#include "filters/core/settings/FrameSettings.h"

namespace umbra {

struct DrawnFrame {
  FrameSettings settings;
  SurfaceImage surfaces;
  std::vector<Cascade> cascades;
  std::vector<const DepthMap*> maps;  // one for each cascade; they must outlive what refers to them
};

// Gives a cascade's map; it is called only for maps that are read.
using MapOf = std::function<const DepthMap&(int cascade)>;
// A request for a read in a frame that was drawn with `settings`, in its format, without
// techniques. It refers to the maps.
ProbeRequest requestOf(const FrameSettings& settings, const std::vector<Cascade>& cascades,
                       const MapOf& mapOf, const SurfacePoint& surface);
// The request for a pixel that shows a surface.
ProbeRequest requestAt(const DrawnFrame& frame, int x, int y);

// Roughly how many taps are read by the pixels for which `counts` is true: judged by every
// sixteenth pixel along both axes.
double tapsOf(const DrawnFrame& frame, const std::function<bool(int x, int y)>& counts);
// The smallest stride s ≥ 1 at which every s-th pixel of every s-th row reads at most `most` taps
// in all, in a frame whose pixels read `taps`.
int strideFor(double taps, double most);

}  // namespace umbra
