#include "app/FrameReads.h"

namespace umbra {

ProbeRequest requestAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const SurfacePoint& surface) {
  ProbeRequest request{.map = frame.depthMap(surface.cascade),
                       .read = {settings.read.filter, surface.u, surface.v, surface.footprint},
                       .kernel = settings.kernel,
                       .format = settings.map.format,
                       .receiver = surface.receiver,
                       .cascade = surface.cascade,
                       .satPrecision = settings.read.satPrecision};
  if (surface.nextCascade <= 0.0) return request;
  const std::vector<Cascade>& cascades = frame.cascades();
  const int next = surface.cascade + 1;
  request.seam.emplace(SeamPart{
      frame.depthMap(next),
      readInCascade(request.read, cascades[surface.cascade], cascades[next], settings.kernel),
      surface.nextCascade});
  return request;
}

}  // namespace umbra
