// One filtered read taken apart: its region, what every technique makes of it, and the truth.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Region.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// In a seam between cascades: the read of the next one's map.
struct SeamPart {
  const DepthMap& map;
  ReadPoint read;
  double weight = 0.0;  // of the next cascade's visibility, below 1
};

struct ProbeRequest {
  const DepthMap& map;
  ReadPoint read;
  Kernel kernel;
  StorageFormat format = StorageFormat::Double;
  double receiver = 0.5;  // z_r, biased
  // Parameters set, adapted to the map; of several cascades to that of the first.
  std::vector<std::shared_ptr<const Technique>> techniques;
  int cascade = 0;  // of whose map `map` is
  std::optional<SeamPart> seam;
  SatPrecision satPrecision = SatPrecision::Centred;
};

struct TechniqueResult {
  std::shared_ptr<const Technique> technique;
  // As read: reduced over the region, stored, interpolated. In a seam those of the heavier part.
  std::vector<double> channels;
  double visibility = 0.0;
  double error = 0.0;                   // visibility − reference: positive is light bleeding
  std::optional<double> gpu;            // the visibility that the shaded frame used at this pixel
  std::vector<double> lighterChannels;  // in a seam: of the other part
};

// In a seam two cascades' maps are read, each technique's two visibilities mixed.
struct ProbeSeam {
  Region heavier, lighter;  // each of weights that sum to 1
  double weight = 0.0;      // of the lighter part's visibility
};

// A technique that cannot be composed with the request's format, kernel and read, and the reason.
struct RefusedTechnique {
  std::shared_ptr<const Technique> technique;
  std::string reason;
};

struct Probe {
  Region region;  // in a seam the union of both cascades' regions, its weights those of the mix
  double receiver = 0.0;
  RegionStatistics statistics;
  double reference = 0.0;  // exact percentage-closer filtering
  std::vector<TechniqueResult> techniques;
  std::vector<RefusedTechnique> refused;  // have no result
  std::optional<ProbeSeam> seam;
};

Probe takeProbe(const ProbeRequest& request);

// What a technique of the probe reads; in a seam the heavier part. Refers to both arguments.
Fetch fetchOf(const Probe& probe, const TechniqueResult& result);
// That of `technique`, with the channels of `result`, at any receiver: the same technique with
// another parameter that its channels do not depend on.
double visibilityOf(const Technique& technique, const Probe& probe, const TechniqueResult& result,
                    double receiver);

// The taps on the map of the cascade that the probe is in; their weights sum to less than 1 in a
// seam.
Region ownRegion(const Probe& probe);

// The read of the next cascade in a seam: the same place on its map, with the footprint in its
// texels; at its edge where it lies beyond. A summed area is at least as wide as the kernel.
ReadPoint readInCascade(const ReadPoint& read, const Cascade& from, const Cascade& to,
                        const Kernel& kernel);

// The region's depths in `bins` ≥ 1 bins of equal width over [min, max]; weights sum to 1. A region
// of one depth has one bin of no width.
struct Histogram {
  std::vector<double> edges;    // bins + 1
  std::vector<double> weights;  // bins
};
Histogram histogramOf(const Region& region, int bins);

// The same of any finite values with weights ≥ 0, scaled to sum 1; values without weight do not
// count. Empty where nothing has weight.
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
Curves curvesOf(const Probe& probe, int samples);

}  // namespace umbra
