#include "analysis/DrawnFrame.h"

#include <algorithm>
#include <cmath>

namespace umbra {

ProbeRequest requestOf(const DrawnFrame& frame, const SurfaceRead& surface) {
  const FrameSettings& settings = frame.settings;
  const int cascade = surface.cascade;
  ProbeRequest request{.map = *frame.maps[cascade],
                       .read = surface.read,
                       .kernel = settings.kernel,
                       .format = settings.map.format,
                       .receiver = surface.receiver,
                       .cascade = cascade,
                       .satPrecision = settings.read.satPrecision};
  if (surface.nextCascade <= 0.0) return request;
  request.seam.emplace(SeamPart{*frame.maps[cascade + 1],
                                readInCascade(request.read, frame.cascades[cascade],
                                              frame.cascades[cascade + 1], settings.kernel),
                                surface.nextCascade});
  return request;
}

ProbeRequest requestAt(const DrawnFrame& frame, int x, int y) {
  const auto values = frame.surfaces.pixel(x, y);
  SurfaceRead surface{{frame.settings.read.filter, values[0], values[1], {}}, std::abs(values[2])};
  if (!frame.footprints.empty()) {
    const auto footprint = frame.footprints.pixel(x, y);
    surface.read.footprint = {footprint[0], footprint[1], int(footprint[2])};
    surface.cascade = int(footprint[3]);
    surface.nextCascade = footprint[3] - float(surface.cascade);
  }
  return requestOf(frame, surface);
}

double tapsOf(const DrawnFrame& frame, const std::function<bool(int x, int y)>& counts) {
  constexpr int step = 16;
  double taps = 0.0;
  for (int y = 0; y < frame.surfaces.height(); y += step)
    for (int x = 0; x < frame.surfaces.width(); x += step)
      if (counts(x, y)) taps += double(takeProbe(requestAt(frame, x, y)).region.texels.size());
  return taps * step * step;
}

int strideFor(double taps, double most) {
  return std::max(1, int(std::ceil(std::sqrt(taps / most))));
}

}  // namespace umbra
