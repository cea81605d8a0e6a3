#include "ui/FrameEvidence.h"

#include <cmath>
#include <utility>

namespace umbra {

// The windows of several cascades follow the camera and the filter's reach.
bool sameMap(const FrameSettings& a, const FrameSettings& b) {
  return a.map.size == b.map.size && a.map.samples == b.map.samples && a.map.cascades.count == 1 &&
         b.map.cascades.count == 1 && a.bias.cullFrontFaces == b.bias.cullFrontFaces;
}

std::optional<FrameProbe> probeFrame(const FrameEvidence& evidence, const FrameSettings& frame,
                                     const std::function<const DepthMap&(int cascade)>& mapOf,
                                     const Pixel& pixel, const std::optional<double>& receiver,
                                     const std::optional<Plane>& plane) {
  const Image<float>& surfaces = evidence.surfaces;
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= surfaces.width() || pixel.y >= surfaces.height())
    return std::nullopt;
  const auto surface = surfaces.pixel(pixel.x, pixel.y);
  const double u = surface[0], v = surface[1];
  if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) return std::nullopt;
  Footprint footprint;
  int cascade = 0;
  double next = 0.0;  // weight of the next cascade
  if (!evidence.footprints.empty()) {
    const auto read = evidence.footprints.pixel(pixel.x, pixel.y);
    footprint = {read[0], read[1], int(read[2])};
    cascade = int(read[3]);
    next = read[3] - double(cascade);
  }
  const double depth = receiver.value_or(std::abs(double(surface[2])));
  ProbeRequest request{.map = mapOf(cascade),
                       .read = {frame.read.filter, u, v, footprint},
                       .kernel = frame.kernel,
                       .format = frame.map.format,
                       .receiver = depth,
                       .techniques = {evidence.technique},
                       .cascade = cascade,
                       .seam = {},
                       .satPrecision = frame.read.satPrecision};
  const Cascade& own = evidence.cascades[std::size_t(cascade)];
  if (next > 0.0) {
    const int after = cascade + 1;
    const Cascade& coarser = evidence.cascades[std::size_t(after)];
    request.seam.emplace(
        SeamPart{mapOf(after), readInCascade(request.read, own, coarser, request.kernel), next});
  }
  FrameProbe probe{takeProbe(request), {}};
  probe.footprint = footprintOf(ownRegion(probe.probe), frame.map.size,
                                std::abs(double(surface[2])), own.frame, plane);
  return probe;
}

}  // namespace umbra
