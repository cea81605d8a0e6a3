// Takes one filtered read apart: its region, the visibility by every technique, and the reference.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Region.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// In a seam between cascades, the read of the next cascade's map.
struct SeamPart {
  const DepthMap& map;
  ReadPoint read;
  double weight = 0.0;  // weight of the next cascade's visibility, below 1
};

struct ProbeRequest {
  const DepthMap& map;
  ReadPoint read;
  Kernel kernel;
  StorageFormat format = StorageFormat::Double;
  double receiver = 0.5;  // z_r, biased
  // Techniques with their parameters set, adapted to the map (the first cascade's, where there are
  // several).
  std::vector<std::shared_ptr<const Technique>> techniques;
  int cascade = 0;  // the cascade that `map` belongs to
  std::optional<SeamPart> seam;
  SatPrecision satPrecision = SatPrecision::Centred;
};

struct TechniqueResult {
  std::shared_ptr<const Technique> technique;
  // The channels as they are read: reduced over the region, stored, interpolated. In a seam they
  // are those of the heavier part.
  std::vector<double> channels;
  double visibility = 0.0;
  double error = 0.0;                   // visibility − reference: positive is light bleeding
  std::optional<double> gpu;            // the visibility that the shaded frame used at this pixel
  std::vector<double> lighterChannels;  // in a seam, the channels of the lighter part
};

// In a seam the maps of two cascades are read, and each technique's two visibilities are mixed.
struct ProbeSeam {
  Region heavier, lighter;  // each has weights that sum to 1
  double weight = 0.0;      // weight of the lighter part's visibility
};

// A technique that cannot be composed with the request's format, kernel and read, and the reason.
struct RefusedTechnique {
  std::shared_ptr<const Technique> technique;
  std::string reason;
};

struct Probe {
  Region region;  // in a seam the union of both cascades' regions, with the weights of the mix
  double receiver = 0.0;
  RegionStatistics statistics;
  double reference = 0.0;  // exact percentage-closer filtering
  std::vector<TechniqueResult> techniques;
  std::vector<RefusedTechnique> refused;  // techniques without a result
  std::optional<ProbeSeam> seam;
};

Probe takeProbe(const ProbeRequest& request);

// The result of the technique with this id; null where the probe has none.
const TechniqueResult* resultOf(const Probe& probe, std::string_view id);

// The fetch of a technique of the probe; in a seam that of the heavier part. It refers to both
// arguments.
Fetch fetchOf(const Probe& probe, const TechniqueResult& result);
// The visibility by `technique` with the channels of `result`, at any receiver. `technique` is the
// result's own, or one that differs in a parameter on which its channels do not depend.
double visibilityOf(const Technique& technique, const Probe& probe, const TechniqueResult& result,
                    double receiver);

// The taps on the map of the cascade that the probe is in. In a seam their weights sum to less than
// 1.
Region ownRegion(const Probe& probe);

// The read of the next cascade in a seam: the same place on its map, at its edge where it lies
// beyond, with the footprint in its texels. A summed area is at least as wide as the kernel.
ReadPoint readInCascade(const ReadPoint& read, const Cascade& from, const Cascade& to,
                        const Kernel& kernel);

// The region's depths in `bins` ≥ 1 bins of equal width over [min, max]; weights sum to 1. A region
// of one depth has one bin of no width.
struct Histogram {
  std::vector<double> edges;    // bins + 1
  std::vector<double> weights;  // bins
};
Histogram histogramOf(const Region& region, int bins);

// The same for any finite values with weights ≥ 0, which are scaled to sum 1; values without weight
// do not count. The result is empty where nothing has weight.
Histogram histogramOf(std::span<const double> values, std::span<const double> weights, int bins);

// The distinct depths of the region, ascending, each with the weight at or below it: F(z).
struct EmpiricalCdf {
  std::vector<double> depth;
  std::vector<double> cumulative;
};
EmpiricalCdf empiricalCdfOf(const Region& region);

// v(z) of the reference and of every technique of the probe, at `samples` depths evenly over [0,1].
struct Curves {
  std::vector<double> depth;
  std::vector<double> reference;
  std::vector<std::vector<double>> techniques;  // in the probe's order
};
// `eachStep` is called now and then, and may throw to interrupt.
Curves curvesOf(const Probe& probe, int samples, const std::function<void()>& eachStep = {});

}  // namespace umbra
