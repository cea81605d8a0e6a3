// Closed forms for scenes that consist of planes across the light: they are predicted, then
// measured.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// Planes at known depths, nearest to the light first; the last one is the receiver. Each plane has
// the share of a region in which the map sees it. Shares sum to 1.
struct PlaneShares {
  std::vector<double> depths;  // [0,1]
  std::vector<double> shares;
};

// How much a texel's depth may differ from the depth of its plane: far more than the 24-bit
// rounding of a map, far less than the distance between planes.
inline constexpr double planeTolerance = 1e-4;

// The share of the probe's region on each plane. Nothing where a part of it lies on no plane, such
// as on a post.
std::optional<PlaneShares> planeSharesOf(const Probe& probe, std::span<const double> depths);

// The visibility by variance shadow maps at depth `receiver`: Lauritzen 2008, eq. 3.3 with the mean
// and variance of these shares, the variance at least `minVariance`. At the receiver's own depth
// and without a smallest variance it is
// p for an occluder over a receiver of which the share p is unoccluded (§3.2), and
// s(1−s)Δx² / (s(1−s)Δx² + (Δy + sΔx)²) for A over B over C, where A covers s of B and B all of
// C: eq. 3.4 for s = ½.
double predictedVisibility(const PlaneShares& planes, double receiver, double minVariance = 0.0);

struct PlanesPrediction {
  PlaneShares planes;
  double predicted = 0.0;  // at the probe's receiver, with the technique's smallest variance
  double ideal = 0.0;      // at the receiving plane's own depth, without it
  double measured = 0.0;   // by technique vsm, without light-bleeding reduction
};

// Nothing where the probe has no technique vsm, or has depths on no plane.
std::optional<PlanesPrediction> predictPlanes(const Probe& probe, std::span<const double> depths);

// Plots the predicted curve over the measured one, over the receiver's depth, with both numbers.
Plot planesPlot(const Probe& probe, const PlanesPrediction& prediction);

// Plots the visibility over the share of the region that the nearest plane covers; the other shares
// keep their proportions. The measured value is marked at the region's own share.
Plot coveragePlot(const Probe& probe, const PlanesPrediction& prediction);

}  // namespace umbra
