// One filtered read taken apart: its region, what every technique makes of it, and the truth.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "filters/core/FrameSettings.h"
#include "filters/core/Region.h"
#include "filters/core/Technique.h"

namespace umbra {

struct ProbeRequest {
  const DepthMap& map;
  ReadPoint read;
  Kernel kernel;
  StorageFormat format = StorageFormat::Double;
  double receiver = 0.5;                                     // z_r, biased
  std::vector<std::shared_ptr<const Technique>> techniques;  // parameters set, adapted to the map
};

struct TechniqueResult {
  std::shared_ptr<const Technique> technique;
  std::vector<double> channels;  // as read: reduced over the region, stored, interpolated
  double visibility = 0.0;
  double error = 0.0;         // visibility − reference: positive is light bleeding
  std::optional<double> gpu;  // the visibility that the shaded frame used at this pixel
};

// A technique that cannot be stored in the format of the request, and the reason.
struct RefusedTechnique {
  std::shared_ptr<const Technique> technique;
  std::string reason;
};

struct Probe {
  Region region;
  double receiver = 0.0;
  RegionStatistics statistics;
  double reference = 0.0;  // exact percentage-closer filtering
  std::vector<TechniqueResult> techniques;
  std::vector<RefusedTechnique> refused;  // have no result
};

Probe takeProbe(const ProbeRequest& request);

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
