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
  // ln of t = (receiver − min)/(max − min) and of t̄ = β/(β+1), both by way of 1 − t: where β is
  // large, t is near 1 and t^β needs all digits of what is missing.
  const double range = max - min;
  const double logT = std::log1p(-(max - receiver) / range);
  const double logMean = std::log1p(-(max - mean) / range);
  const double above = -std::expm1(beta * logT);
  const double aboveMean = -std::expm1(beta * logMean);
  return std::clamp(above / aboveMean, 0.0, 1.0);
}

}  // namespace umbra
