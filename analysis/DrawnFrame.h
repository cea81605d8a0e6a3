// A drawn frame as plain data: what every pixel of it reads can be told on any thread, without
// OpenGL.
#pragma once

#include <functional>
#include <vector>

#include "analysis/Probe.h"
#include "analysis/SurfaceRead.h"
#include "filters/core/Cascades.h"
#include "filters/core/FrameSettings.h"
#include "filters/core/Image.h"

namespace umbra {

struct DrawnFrame {
  FrameSettings settings;
  // Both as ShadowRenderer gives them. Footprints are empty where the frame's reads have none.
  Image<float> surfaces, footprints;
  std::vector<Cascade> cascades;
  std::vector<const DepthMap*> maps;  // of each cascade; they must outlive what refers to them
};

// A read of the frame's maps in its format, without techniques. Refers to the maps.
ProbeRequest requestOf(const DrawnFrame& frame, const SurfaceRead& surface);
// That of a pixel which shows a surface.
ProbeRequest requestAt(const DrawnFrame& frame, int x, int y);

// Roughly how many taps the frame's pixels read that `counts` says yes to: judged by every
// sixteenth of them along both axes.
double tapsOf(const DrawnFrame& frame, const std::function<bool(int x, int y)>& counts);
// Of a frame with so many taps, every how-manieth pixel of every how-manieth row reads `most` or
// fewer in all; at least 1.
int strideFor(double taps, double most);

}  // namespace umbra
