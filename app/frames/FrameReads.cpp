#include "app/frames/FrameReads.h"

namespace umbra {

DrawnFrame drawnFrame(HeadlessFrame& frame, const FrameSettings& settings) {
  DrawnFrame drawn{settings, frame.surfaces(), frame.cascades(), {}};
  for (int i = 0; i < int(drawn.cascades.size()); ++i) drawn.maps.push_back(&frame.depthMap(i));
  return drawn;
}

ProbeRequest requestAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const SurfacePoint& surface) {
  const auto mapOf = [&](int cascade) -> const DepthMap& { return frame.depthMap(cascade); };
  return requestOf(settings, frame.cascades(), mapOf, surface);
}

}  // namespace umbra
