// A drawn frame as plain data: what every pixel of it reads can be told on any thread, without
// OpenGL.
#pragma once

#include <functional>
#include <vector>

#include "analysis/probe/Probe.h"
#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Image.h"
#include "filters/core/maps/SurfacePoint.h"
#include "filters/core/settings/FrameSettings.h"

namespace umbra {

struct DrawnFrame {
  FrameSettings settings;
  // Both as ShadowRenderer gives them. Footprints are empty where the frame's reads have none.
  Image<float> surfaces, footprints;
  std::vector<Cascade> cascades;
  std::vector<const DepthMap*> maps;  // of each cascade; they must outlive what refers to them
};

// Of a pixel that shows one, without its place in the world; both images as in DrawnFrame.
SurfacePoint surfaceAt(const Image<float>& surfaces, const Image<float>& footprints, int x, int y);

// A cascade's map; asked for only where it is read.
using MapOf = std::function<const DepthMap&(int cascade)>;
// A read in the format of a frame that was drawn with `settings`, without techniques. Refers to the
// maps.
ProbeRequest requestOf(const FrameSettings& settings, const std::vector<Cascade>& cascades,
                       const MapOf& mapOf, const SurfacePoint& surface);
// That of a pixel which shows a surface.
ProbeRequest requestAt(const DrawnFrame& frame, int x, int y);

// Roughly how many taps the frame's pixels read that `counts` says yes to: judged by every
// sixteenth of them along both axes.
double tapsOf(const DrawnFrame& frame, const std::function<bool(int x, int y)>& counts);
// Of a frame with so many taps, every how-manieth pixel of every how-manieth row reads `most` or
// fewer in all; at least 1.
int strideFor(double taps, double most);

}  // namespace umbra
