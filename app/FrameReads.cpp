#include "app/FrameReads.h"

namespace umbra {

namespace {

DrawnFrame mapsOf(HeadlessFrame& frame, const FrameSettings& settings) {
  DrawnFrame drawn{settings, {}, {}, frame.cascades(), {}};
  for (int i = 0; i < int(drawn.cascades.size()); ++i) drawn.maps.push_back(&frame.depthMap(i));
  return drawn;
}

}  // namespace

DrawnFrame drawnFrame(HeadlessFrame& frame, const FrameSettings& settings) {
  DrawnFrame drawn = mapsOf(frame, settings);
  drawn.surfaces = frame.surfaces();
  drawn.footprints = frame.footprints();
  return drawn;
}

ProbeRequest requestAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const SurfacePoint& surface) {
  return requestOf(mapsOf(frame, settings),
                   {{settings.read.filter, surface.u, surface.v, surface.footprint},
                    surface.receiver,
                    surface.facesLight,
                    surface.cascade,
                    surface.nextCascade});
}

}  // namespace umbra
