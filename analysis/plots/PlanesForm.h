// Closed forms of scenes that consist of planes across the light: predicted before measured.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// Planes at known depths, nearest to the light first, the last one being the receiver, and the
// share of a region that the map sees of each. Shares sum to 1.
struct PlaneShares {
  std::vector<double> depths;  // [0,1]
  std::vector<double> shares;
};

// By how much a texel's depth may differ from the plane's that it belongs to: far more than 24-bit
// rounding of a map, far less than the distance between planes.
inline constexpr double planeTolerance = 1e-4;

// What share of the probe's region lies on each plane; none where some of it lies on no plane, such
// as a post.
std::optional<PlaneShares> planeSharesOf(const Probe& probe, std::span<const double> depths);

// Visibility by variance shadow maps at depth `receiver`: Lauritzen 2008, eq. 3.3 with the mean and
// variance that these shares have, the variance at least `minVariance`. At the receiver's own depth
// and without a smallest variance it is
//   p for an occluder over a receiver of which the share p is unoccluded (§3.2), and
//   s(1−s)Δx² / (s(1−s)Δx² + (Δy + sΔx)²) for A over B over C, where A covers s of B and B all of
//   C: eq. 3.4 for s = ½.
double predictedVisibility(const PlaneShares& planes, double receiver, double minVariance = 0.0);

struct PlanesPrediction {
  PlaneShares planes;
  double predicted = 0.0;  // at the probe's receiver, with the technique's smallest variance
  double ideal = 0.0;      // at the receiving plane's own depth, without it
  double measured = 0.0;   // by technique vsm, without light-bleeding reduction
};

// None where the probe has no technique vsm, or depths on no plane.
std::optional<PlanesPrediction> predictPlanes(const Probe& probe, std::span<const double> depths);

// The predicted curve over the measured one, over the receiver's depth, with both numbers.
Plot planesPlot(const Probe& probe, const PlanesPrediction& prediction);

// The visibility over the share of the region that the nearest plane covers, the other shares
// keeping their proportions, with the measured value at the region's own share.
Plot coveragePlot(const Probe& probe, const PlanesPrediction& prediction);

}  // namespace umbra
