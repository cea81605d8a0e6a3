#include "app/RayTracedFrame.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/ReceiverPixels.h"
#include "app/Cancellation.h"
#include "app/EveryCore.h"
#include "app/FrameReads.h"

namespace umbra {
namespace {

// Taps that are looked up for a picture, at most: some ten seconds on one core.
constexpr double mostTaps = 1e9;

struct PixelRead {
  int x = 0, y = 0;
  ProbeRequest request;
};

// The receiving pixels of every `stride`-th row from `first` to before `end`. OpenGL answers to one
// thread only, so they are gathered before they are shared out.
std::vector<PixelRead> readsOf(HeadlessFrame& frame, const FrameSettings& settings,
                               const Image<float>& surfaces, int first, int end, int stride) {
  std::vector<PixelRead> reads;
  for (int y = first; y < std::min(end, surfaces.height()); y += stride) {
    throwIfCancelled();
    for (int x = 0; x < surfaces.width(); x += stride)
      if (receivesShadow(surfaces.pixel(x, y)))
        reads.push_back(
            {x, y, requestAt(frame, settings, surfaceAt(frame, settings, surfaces, x, y))});
  }
  return reads;
}

// So that the picture takes no more than the most taps, judged by every sixteenth pixel.
int strideFor(HeadlessFrame& frame, const FrameSettings& settings, const Image<float>& surfaces) {
  constexpr int coarse = 16;
  double taps = 0.0;
  for (const PixelRead& read : readsOf(frame, settings, surfaces, 0, surfaces.height(), coarse))
    taps += double(takeProbe(read.request).region.texels.size());
  return std::max(1, int(std::ceil(coarse * std::sqrt(taps / mostTaps))));
}

}  // namespace

RayTracedVisibility lightRays(HeadlessFrame& frame, const Scene& scene,
                              const FrameSettings& settings, int side) {
  return RayTracedVisibility(scene, frame.cascades(), frame.depthMap().width(),
                             settings.bias.cullFrontFaces, side);
}

RayTracedReference rayTracedReference(HeadlessFrame& frame, const Scene& scene,
                                      const FrameSettings& settings) {
  const Image<float> surfaces = frame.surfaces();
  const int cascades = int(frame.cascades().size());
  const int side = RayTracedVisibility::sideFor(frame.depthMap().width(), cascades);
  // A penumbra has many texels: four places to a side of each leave an error far below a filter's.
  const RayTracedVisibility rays = lightRays(frame, scene, settings, std::min(side, 4));
  const int stride = strideFor(frame, settings, surfaces);
  RayTracedReference result{
      Image<float>(surfaces.width(), surfaces.height(), 1, RayTracedReference::absent), stride};
  const int rows = 32 * stride;
  for (int first = 0; first < surfaces.height(); first += rows) {
    const auto reads = readsOf(frame, settings, surfaces, first, first + rows, stride);
    constexpr int share = 64;
    onEveryCore((int(reads.size()) + share - 1) / share, [&](int part) {
      for (int i = part * share; i < std::min((part + 1) * share, int(reads.size())); ++i) {
        const Probe probe = takeProbe(reads[i].request);
        result.visibility(reads[i].x, reads[i].y) = float(rays(probe.region, probe.receiver));
      }
    });
  }
  return result;
}

double rayTracedVisibility(HeadlessFrame& frame, const Scene& scene, const FrameSettings& settings,
                           const Probe& probe) {
  return lightRays(frame, scene, settings, RayTracedVisibility::largestSide)(probe.region,
                                                                             probe.receiver);
}

}  // namespace umbra
