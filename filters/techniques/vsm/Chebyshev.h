// The one-tailed Chebyshev (Cantelli) bound that every variance technique rests on.
#pragma once

#include <algorithm>

namespace umbra {

// P(x ≥ t) ≤ σ² / (σ² + (t − μ)²) for t > μ, else 1 (Lauritzen 2008, eq. 3.3), with the variance
// M2 − M1² (eq. 3.2) clamped below. M1, M2 and t are depths of any one warp; minVariance is in the
// square of their unit and > 0 unless the true variance is. Result in [0,1].
inline double chebyshevUpperBound(double m1, double m2, double t, double minVariance) {
  if (t <= m1) return 1.0;
  const double variance = std::max(m2 - m1 * m1, minVariance);
  const double distance = t - m1;
  return variance / (variance + distance * distance);
}

// Cuts the tail off: [amount, 1] is stretched to [0, 1] (Lauritzen 2008, §3.4; amount in [0, 1)).
inline double reduceLightBleeding(double visibility, double amount) {
  return std::clamp((visibility - amount) / (1.0 - amount), 0.0, 1.0);
}

}  // namespace umbra
