#include "analysis/frame/DrawnFrame.h"

#include <algorithm>
#include <cmath>

namespace umbra {

SurfacePoint surfaceAt(const Image<float>& surfaces, const Image<float>& footprints, int x, int y) {
  const auto values = surfaces.pixel(x, y);
  SurfacePoint surface;
  surface.u = values[0];
  surface.v = values[1];
  surface.receiver = std::abs(values[2]);
  surface.visibility = values[3];
  surface.facesLight = values[2] > 0.0f;
  if (footprints.empty()) return surface;
  const auto footprint = footprints.pixel(x, y);
  surface.footprint = {footprint[0], footprint[1], int(footprint[2])};
  surface.cascade = int(footprint[3]);
  surface.nextCascade = footprint[3] - float(surface.cascade);
  return surface;
}

ProbeRequest requestOf(const FrameSettings& settings, const std::vector<Cascade>& cascades,
                       const MapOf& mapOf, const SurfacePoint& surface) {
  const int cascade = surface.cascade;
  ProbeRequest request{.map = mapOf(cascade),
                       .read = {settings.read.filter, surface.u, surface.v, surface.footprint},
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
                   surfaceAt(frame.surfaces, frame.footprints, x, y));
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
