// The closed form of a region that two occluders cover, for the tests of plots.
#pragma once

namespace umbra {

// Two occluders A and B, both nearer than the receiver C, cover the shares s and 1 − s of a region:
// the reference is 0, and this is eq. 3.3 of Lauritzen 2008 at C, with μ = B − sΔx and
// σ² = s(1 − s)Δx². `dx` = B − A, `dy` = C − B, both ≥ 0 and one of them > 0. For s = ½ it is eq.
// 3.4: ¼Δx² / (½Δx² + ΔxΔy + Δy²).
inline double bleedingOfTwoOccluders(double dx, double dy, double shareOfA = 0.5) {
  const double variance = shareOfA * (1.0 - shareOfA) * dx * dx;
  const double distance = dy + shareOfA * dx;
  return variance / (variance + distance * distance);
}

}  // namespace umbra
