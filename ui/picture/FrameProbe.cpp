#include "ui/picture/FrameProbe.h"

#include "analysis/frame/FrameReads.h"

namespace umbra {

std::optional<FrameProbe> probeFrame(const FrameSnapshot& frame, const Pixel& pixel,
                                     const std::optional<double>& receiver,
                                     const std::optional<Plane>& plane) {
  const std::optional<SurfacePoint> surface = frame.surfaces.at(pixel.x, pixel.y);
  if (!surface || !surface->isInMap()) return std::nullopt;
  ProbeRequest request = requestOf(frame, *surface);
  request.receiver = receiver.value_or(surface->receiver);
  request.techniques = {frame.technique};
  FrameProbe probe{takeProbe(request), {}};
  probe.footprint = footprintOf(ownRegion(probe.probe), frame.settings.map.size, surface->receiver,
                                frame.cascades[std::size_t(surface->cascade)].frame, plane);
  return probe;
}

}  // namespace umbra
