#include "app/frames/RayTracedFrame.h"

#include <algorithm>

#include "analysis/errors/BleedReduction.h"
#include "analysis/frame/EveryCore.h"
#include "analysis/frame/FrameReads.h"
#include "app/output/Cancellation.h"

namespace umbra {
namespace {

// The most taps that are looked up for a picture: some ten seconds on one core.
constexpr double mostTaps = 1e9;

// `side` × `side` rays in every texel.
std::unique_ptr<RayTracedVisibility> raysWith(const FrameSnapshot& frame, int side) {
  return std::make_unique<RayTracedVisibility>(*frame.scene, frame.cascades,
                                               frame.maps.front()->width(),
                                               frame.settings.bias.cullFrontFaces, side);
}

}  // namespace

// A penumbra has many texels: 4 × 4 rays in each leave an error far below a filter's.
std::unique_ptr<RayTracedVisibility> raysFor(const FrameSnapshot& frame) {
  const int side =
      RayTracedVisibility::sideFor(frame.maps.front()->width(), int(frame.cascades.size()));
  return raysWith(frame, std::min(side, 4));
}

RayTracedReference rayTracedReference(HeadlessFrame& frame) {
  const auto snapshot = frame.snapshot();
  const FrameSnapshot& drawn = *snapshot;
  const SurfaceImage& surfaces = drawn.surfaces;
  const auto receives = [&](int x, int y) { return surfaces.receivesShadow(x, y); };
  const std::unique_ptr<RayTracedVisibility> rays = raysFor(drawn);
  const int stride = strideFor(tapsOf(drawn, receives), mostTaps);
  RayTracedReference result{Image<float>(surfaces.width(), surfaces.height(), 1, noReference),
                            stride};
  const auto trace = [&](int row) {
    const int y = row * stride;
    for (int x = 0; x < surfaces.width(); x += stride) {
      if (!receives(x, y)) continue;
      const Probe probe = takeProbe(requestAt(drawn, x, y));
      result.visibility(x, y) = float((*rays)(probe.region, probe.receiver));
    }
  };
  onEveryCore((surfaces.height() + stride - 1) / stride, trace, [](int) { throwIfCancelled(); });
  return result;
}

double rayTracedVisibility(HeadlessFrame& frame, const Probe& probe) {
  const auto rays = raysWith(*frame.snapshot(), RayTracedVisibility::largestSide);
  return (*rays)(probe.region, probe.receiver);
}

}  // namespace umbra
