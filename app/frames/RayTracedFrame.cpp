#include "app/frames/RayTracedFrame.h"

#include <algorithm>

#include "analysis/errors/BleedReduction.h"
#include "analysis/frame/EveryCore.h"
#include "app/frames/FrameReads.h"
#include "app/output/Cancellation.h"

namespace umbra {
namespace {

// The most taps that are looked up for a picture: some ten seconds on one core.
constexpr double mostTaps = 1e9;

}  // namespace

RayTracedVisibility lightRays(HeadlessFrame& frame, const Scene& scene,
                              const FrameSettings& settings, int side) {
  return RayTracedVisibility(scene, frame.cascades(), frame.depthMap().width(),
                             settings.bias.cullFrontFaces, side);
}

RayTracedReference rayTracedReference(HeadlessFrame& frame, const Scene& scene,
                                      const FrameSettings& settings) {
  const DrawnFrame drawn = drawnFrame(frame, settings);
  const SurfaceImage& surfaces = drawn.surfaces;
  const auto receives = [&](int x, int y) { return surfaces.receivesShadow(x, y); };
  const int cascades = int(drawn.cascades.size());
  const int side = RayTracedVisibility::sideFor(drawn.maps.front()->width(), cascades);
  // A penumbra has many texels: 4 × 4 rays in each leave an error far below a filter's.
  const RayTracedVisibility rays = lightRays(frame, scene, settings, std::min(side, 4));
  const int stride = strideFor(tapsOf(drawn, receives), mostTaps);
  RayTracedReference result{Image<float>(surfaces.width(), surfaces.height(), 1, noReference),
                            stride};
  const auto trace = [&](int row) {
    const int y = row * stride;
    for (int x = 0; x < surfaces.width(); x += stride) {
      if (!receives(x, y)) continue;
      const Probe probe = takeProbe(requestAt(drawn, x, y));
      result.visibility(x, y) = float(rays(probe.region, probe.receiver));
    }
  };
  onEveryCore((surfaces.height() + stride - 1) / stride, trace, [](int) { throwIfCancelled(); });
  return result;
}

double rayTracedVisibility(HeadlessFrame& frame, const Scene& scene, const FrameSettings& settings,
                           const Probe& probe) {
  return lightRays(frame, scene, settings, RayTracedVisibility::largestSide)(probe.region,
                                                                             probe.receiver);
}

}  // namespace umbra
