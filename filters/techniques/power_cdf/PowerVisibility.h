// The visibility of a depth distribution that is approximated by a power function.
#pragma once

#include <algorithm>
#include <cmath>

namespace umbra {

// Gumbau et al. 2011, eq. 4 with β of eq. 3: F(t) = t^β over [min, max] with the given mean.
// All four are depths of one unit, min ≤ max; a mean beyond them by rounding counts as the nearer.
// The receiver is lit up to the mean. Result in [0,1].
inline double powerVisibility(double mean, double min, double max, double receiver) {
  mean = std::clamp(mean, min, max);
  if (receiver <= mean) return 1.0;
  // From here on mean < receiver < max, so that β is finite, and min < mean makes it positive.
  if (receiver >= max || mean <= min) return 0.0;
  const double beta = (mean - min) / (max - mean);
  // ln of t = (receiver − min)/(max − min) and of t̄ = β/(β+1). Where t is near 1, t^β needs all
  // digits of 1 − t.
  const double range = max - min;
  const auto logOf = [&](double depth) {
    const double t = (depth - min) / range;
    return t < 0.5 ? std::log(t) : std::log1p(-(max - depth) / range);
  };
  const double above = -std::expm1(beta * logOf(receiver));
  const double aboveMean = -std::expm1(beta * logOf(mean));
  return std::clamp(above / aboveMean, 0.0, 1.0);
}

}  // namespace umbra
