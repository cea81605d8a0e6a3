// The visibility of a depth distribution that is approximated by a power function.
#pragma once

#include <algorithm>
#include <cmath>

#include "filters/core/technique/Trace.h"

namespace umbra {

// Gumbau et al. 2011, eq. 4 with β of eq. 3: F(t) = t^β over [min, max] with the given mean.
// All four are depths of one unit, min ≤ max; a mean beyond them by rounding counts as the nearer.
// The receiver is lit up to the mean. Result in [0,1]. `record` takes the steps.
template <class Record>
double powerVisibility(double mean, double min, double max, double receiver, const Record& record) {
  mean = std::clamp(mean, min, max);
  record("z̄", "mean of the region", "", mean);
  record("min", "the region's nearest depth", "", min);
  record("max", "the region's farthest depth", "", max);
  if (receiver <= mean)
    return record("v", "lit: the receiver is not behind the mean", "1 for z_r ≤ z̄", 1.0);
  // From here on mean < receiver < max, so that β is finite, and min < mean makes it positive.
  if (receiver >= max)
    return record("v", "dark: the receiver is the farthest depth, or behind it", "0 for z_r ≥ max",
                  0.0);
  if (mean <= min) return record("v", "dark: the mean is the minimum, β = 0", "0 for β = 0", 0.0);
  const double beta = record("β", "exponent of the distribution", "(z̄ − min)/(max − z̄)",
                             (mean - min) / (max - mean));
  // ln of t = (receiver − min)/(max − min) and of t̄ = β/(β+1). Where t is near 1, t^β needs all
  // digits of 1 − t.
  const double range = max - min;
  const auto logOf = [&](double depth) {
    const double t = (depth - min) / range;
    return t < 0.5 ? std::log(t) : std::log1p(-(max - depth) / range);
  };
  record("t", "receiver's place between them", "(z_r − min)/(max − min)", (receiver - min) / range);
  const double above = record("1 − t^β", "share of depths behind it", "1 − t^β",
                              -std::expm1(beta * logOf(receiver)));
  const double aboveMean = record("1 − t̄^β", "share behind the mean, where v is 1",
                                  "1 − (β/(β+1))^β", -std::expm1(beta * logOf(mean)));
  return record("v", "visibility", "(1 − t^β)/(1 − t̄^β)", std::clamp(above / aboveMean, 0.0, 1.0));
}

inline double powerVisibility(double mean, double min, double max, double receiver) {
  return powerVisibility(mean, min, max, receiver, Unrecorded());
}

}  // namespace umbra
