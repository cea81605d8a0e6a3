#include "analysis/DrawnFrame.h"

#include <algorithm>
#include <cmath>

namespace umbra {

SurfaceRead readAt(const Image<float>& surfaces, const Image<float>& footprints, ReadFilter filter,
                   int x, int y) {
  const auto values = surfaces.pixel(x, y);
  SurfaceRead surface{{filter, values[0], values[1], {}}, std::abs(values[2])};
  if (footprints.empty()) return surface;
  const auto footprint = footprints.pixel(x, y);
  surface.read.footprint = {footprint[0], footprint[1], int(footprint[2])};
  surface.cascade = int(footprint[3]);
  surface.nextCascade = footprint[3] - float(surface.cascade);
  return surface;
}

ProbeRequest requestOf(const FrameSettings& settings, const std::vector<Cascade>& cascades,
                       const MapOf& mapOf, const SurfaceRead& surface) {
  const int cascade = surface.cascade;
  ProbeRequest request{.map = mapOf(cascade),
                       .read = surface.read,
                       .kernel = settings.kernel,
                       .format = settings.map.format,
                       .receiver = surface.receiver,
                       .cascade = cascade,
                       .satPrecision = settings.read.satPrecision};
  if (surface.nextCascade > 0.0)
    request.seam.emplace(SeamPart{
        mapOf(cascade + 1),
        readInCascade(request.read, cascades[cascade], cascades[cascade + 1], settings.kernel),
        surface.nextCascade});
  return request;
}

ProbeRequest requestAt(const DrawnFrame& frame, int x, int y) {
  const auto mapOf = [&](int cascade) -> const DepthMap& { return *frame.maps[cascade]; };
  return requestOf(frame.settings, frame.cascades, mapOf,
                   readAt(frame.surfaces, frame.footprints, frame.settings.read.filter, x, y));
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
