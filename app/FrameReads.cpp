#include "app/FrameReads.h"

namespace umbra {

SurfacePoint surfaceAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const Image<float>& surfaces, int x, int y) {
  const ReadFilter filter = settings.read.filter;
  const bool plain = filter == ReadFilter::Point || filter == ReadFilter::Bilinear;
  if (!plain || frame.cascades().size() > 1) return frame.surfaceAt(x, y).value();
  SurfacePoint point;
  point.u = surfaces(x, y, 0);
  point.v = surfaces(x, y, 1);
  point.receiver = surfaces(x, y, 2);
  point.visibility = surfaces(x, y, 3);
  return point;
}

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
