// How the Chebyshev bound of variance shadow maps moves when the region's depths do.
#pragma once

#include <optional>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// p_max = σ² / (σ² + (z_r − μ)²) for z_r > μ, else 1 (Lauritzen 2008, eq. 3.3). Depths and their
// variance in one unit; a region without variance is dark behind its mean.
double chebyshevBound(double mean, double variance, double receiver);

// Two occluders A and B, both nearer than the receiver C, cover the shares s and 1 − s of a region:
// the reference is 0. `dx` = B − A, `dy` = C − B, both ≥ 0 and one of them > 0. For s = ½ this is
// Lauritzen 2008, eq. 3.4: ¼Δx² / (½Δx² + ΔxΔy + Δy²).
double bleedingOfTwoOccluders(double dx, double dy, double shareOfA = 0.5);

// Replaces a region's occluders by two planes with the same nearest and farthest depth and the same
// mean. Nothing where no occluder lies in front of the receiver.
struct TwoOccluders {
  double a = 0.0, b = 0.0, c = 0.0;  // depths of A, B and the receiver
  double shareOfA = 0.5;  // share of the occluders' weight; arbitrary where A and B coincide
};
std::optional<TwoOccluders> twoOccludersOf(const Probe& probe);

// p_max over the receiver's depth for ½, 1, 2 and 4 times the region's variance.
Plot varianceFamilyPlot(const Probe& probe);

// Light bleeding on C as A moves away from B, with the region's B, C and shares, and for half and
// twice the distance from B to C; the region's own Δx is marked.
Plot occluderDistancePlot(const Probe& probe);

}  // namespace umbra
