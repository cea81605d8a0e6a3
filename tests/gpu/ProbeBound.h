// How far the visibility that a frame used at a pixel may be from that of a probe there.
#pragma once

#include <cmath>

#include "analysis/probe/Probe.h"
#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/settings/FrameSettings.h"
#include "tests/gpu/Rounding.h"
#include "tests/gpu/SatBound.h"

namespace umbra::test {

// For one technique in frames of these settings, which must outlive it; `map` is one that is read.
class ProbeBound {
 public:
  ProbeBound(const Technique& technique, const FrameSettings& settings, const DepthMap& map)
      : technique_(technique),
        settings_(settings),
        visibility_(technique, settings.map.format),
        sums_(technique, settings.map.format, encodeMap(map, technique, settings.map.format)) {}

  // `probe` was taken of `request`, whose only technique is this one.
  double operator()(const ProbeRequest& request, const Probe& probe) const {
    const ReadPoint& read = request.read;
    const Fetch fetch{probe.techniques.front().channels, probe.region};
    const auto visibility = [&](const ReadPoint& at) {
      ProbeRequest moved = request;
      moved.read = at;
      return takeProbe(moved).techniques.front().visibility;
    };
    const double place = readError(visibility, read);
    // Sums along both axes of a region, each as long as it has texels there.
    const double summing = 2 * (4 * std::hypot(read.footprint.x, read.footprint.y) + 32) * eps;
    if (!technique_.info().prefilterable)
      return visibility_(fetch, request.receiver) + summing + place;
    if (read.filter == ReadFilter::SummedArea)
      return visibility_(fetch, request.receiver, 0, sums_(request.satPrecision, read)) + place;
    // Roundings of the blur along two axes, of three for each of up to seven levels, of the mixes.
    const int reading =
        2 * (2 * settings_.kernel.radius + 3) + 3 * 7 + 12 + read.footprint.probes + 2;
    return visibility_(fetch, request.receiver, reading) + place;
  }

 private:
  const Technique& technique_;
  const FrameSettings& settings_;
  VisibilityBound visibility_;
  SatBound sums_;
};

}  // namespace umbra::test
