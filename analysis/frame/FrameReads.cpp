#include "analysis/frame/FrameReads.h"

#include <algorithm>
#include <cmath>

namespace umbra {

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

ProbeRequest requestOf(const FrameSnapshot& frame, const SurfacePoint& surface) {
  const auto mapOf = [&](int cascade) -> const DepthMap& {
    return *frame.maps[std::size_t(cascade)];
  };
  return requestOf(frame.settings, frame.cascades, mapOf, surface);
}

ProbeRequest requestAt(const FrameSnapshot& frame, int x, int y) {
  return requestOf(frame, frame.surfaces.at(x, y).value());
}

double tapsOf(const FrameSnapshot& frame, const std::function<bool(int x, int y)>& counts) {
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
