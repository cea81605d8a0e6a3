#include "ui/picture/FrameEvidence.h"

namespace umbra {

// The windows of several cascades follow the camera and the filter's reach.
bool sameMap(const FrameSettings& a, const FrameSettings& b) {
  return a.map.size == b.map.size && a.map.samples == b.map.samples && a.map.cascades.count == 1 &&
         b.map.cascades.count == 1 && a.bias.cullFrontFaces == b.bias.cullFrontFaces;
}

std::optional<FrameProbe> probeFrame(const FrameEvidence& evidence, const FrameSettings& frame,
                                     const MapOf& mapOf, const Pixel& pixel,
                                     const std::optional<double>& receiver,
                                     const std::optional<Plane>& plane) {
  const std::optional<SurfacePoint> surface = evidence.surfaces.at(pixel.x, pixel.y);
  if (!surface || !surface->isInMap()) return std::nullopt;
  ProbeRequest request = requestOf(frame, evidence.cascades, mapOf, *surface);
  request.receiver = receiver.value_or(surface->receiver);
  request.techniques = {evidence.technique};
  FrameProbe probe{takeProbe(request), {}};
  probe.footprint = footprintOf(ownRegion(probe.probe), frame.map.size, surface->receiver,
                                evidence.cascades[std::size_t(surface->cascade)].frame, plane);
  return probe;
}

}  // namespace umbra
