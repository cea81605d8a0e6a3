// The one-tailed Chebyshev (Cantelli) bound that every variance technique rests on.
#pragma once

#include <algorithm>

namespace umbra {

// P(x ≥ t) ≤ σ² / (σ² + (t − μ)²) for t > μ, else 1 (Lauritzen 2008, eq. 3.3), with the variance
// M2 − M1² (eq. 3.2) clamped below. M1, M2 and t are depths of any one warp; minVariance is in the
// square of their unit. Without any variance, what lies behind the mean is dark, however small the
// distance: its square may vanish. Result in [0,1].
inline double chebyshevUpperBound(double m1, double m2, double t, double minVariance) {
  if (t <= m1) return 1.0;
  const double variance = std::max(m2 - m1 * m1, minVariance);
  if (!(variance > 0.0)) return 0.0;
  const double distance = t - m1;
  return variance / (variance + distance * distance);
}

// Cuts the tail off: [amount, 1] is stretched to [0, 1] (Lauritzen 2007, GPU Gems 3,
// ch. 8; amount in [0, 1)).
inline double reduceLightBleeding(double visibility, double amount) {
  return std::clamp((visibility - amount) / (1.0 - amount), 0.0, 1.0);
}

// How much steeper the result rises than what it is made of.
inline double reductionSlope(double amount) {
  return 1.0 / (1.0 - amount);
}

// The whole chain from two moments to the visibility: eq. 3.2 and 3.3, lit for t ≤ M1, then the
// reduction. `record` takes its steps (TraceRecorder, Unrecorded).
template <class Record>
double chebyshevVisibility(double m1, double m2, double t, double minVariance, double reduction,
                           const Record& record) {
  record("μ", "mean of the region", "M1", m1);
  record("M2", "mean of the squares", "", m2);
  record("t − μ", "receiver behind the mean", "", t - m1);
  if (t <= m1) return record("v", "lit: the receiver is not behind the mean", "1 for t ≤ μ", 1.0);
  const double variance = record("σ²", "variance of the region", "M2 − μ²", m2 - m1 * m1);
  record("σ²min", "smallest variance", "", minVariance);
  record("σ²₊", "variance that is used", "max(σ², σ²min)", std::max(variance, minVariance));
  const double bound = record("p_max", "Chebyshev's upper bound", "σ²₊ / (σ²₊ + (t − μ)²)",
                              chebyshevUpperBound(m1, m2, t, minVariance));
  record("a", "light-bleeding reduction", "", reduction);
  return record("v", "visibility", "clamp((p_max − a)/(1 − a), 0, 1)",
                reduceLightBleeding(bound, reduction));
}

}  // namespace umbra
