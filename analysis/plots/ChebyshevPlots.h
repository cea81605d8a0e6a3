// How the Chebyshev bound of variance shadow maps moves when the region's depths do.
#pragma once

#include <optional>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// p_max = σ² / (σ² + (z_r − μ)²) for z_r > μ, else 1 (Lauritzen 2008, eq. 3.3). Depths and their
// variance in one unit; a region without variance is dark behind its mean.
double chebyshevBound(double mean, double variance, double receiver);

// The texels of a region that lie in front of the receiver, to be moved; the others stay.
class Occluders {
 public:
  // Nothing where none lies in front, or where all that do have one depth: they cannot be drawn
  // apart.
  static std::optional<Occluders> of(const Probe& probe);

  double spread() const { return spread_; }  // Δx, from the farthest, B, to the nearest, A; > 0
  double gap() const { return gap_; }        // Δy, from B to the receiver; > 0
  // p_max at the receiver once every occluder's distance to B is scaled so that A is `dx` from B,
  // and all are moved so that B is `dy` in front of the receiver.
  double boundAt(double dx, double dy) const;

 private:
  double spread_ = 0.0, gap_ = 0.0;
  // The occluders' weight, and the weighted sums of B − d and of its square over them.
  double weight_ = 0.0, apart_ = 0.0, apartSquared_ = 0.0;
  // The weighted sums of d − z_r and of its square over the other texels.
  double behind_ = 0.0, behindSquared_ = 0.0;
};

// p_max over the receiver's depth for ½, 1, 2 and 4 times the region's variance.
Plot varianceFamilyPlot(const Probe& probe);

// The bound at the receiver as the region's own occluders move apart, and for half and twice their
// distance to the receiver; the region as it is is marked. Nothing where Occluders has nothing.
std::optional<Plot> occluderDistancePlot(const Probe& probe);

}  // namespace umbra
