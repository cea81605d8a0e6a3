// The bounds in exponentially warped depth that evsm2 and evsm4 share (Lauritzen 2008, §4.2).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "filters/core/technique/Technique.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::evsm {

struct WarpSettings {
  double positiveExponent = 40.0;  // 1/depth
  double negativeExponent = 0.0;   // 1/depth; 0 is no second warp
  double minVariance = 0.0;        // depth², unwarped
  double bleedReduction = 0.0;
};

// A warp and its steepness in one number: e^{c(z−½)} for c > 0, −e^{c(z−½)} for c < 0. Both rise
// with z. The shift by ½ is a factor, to which the Chebyshev bound is indifferent.
inline double warped(double z, double c) {
  return std::copysign(std::exp(c * (z - 0.5)), c);
}

// The moments of one warp, as they are stored.
inline void encodeWarp(double z, double c, double& first, double& second) {
  first = warped(z, c);
  second = first * first;
}

template <class Record>
double boundOfWarp(double m1, double m2, double c, double receiver, const WarpSettings& settings,
                   const Record& record) {
  record("c", "exponent of the warp", "", c);
  const double t = record("t", "receiver's depth, warped",
                          c > 0.0 ? "e^(c(z_r − ½))" : "−e^(c(z_r − ½))", warped(receiver, c));
  // A depth interval at the receiver is longer by the warp's slope there, dg/dz = c·g.
  const double slope = c * t;
  return chebyshevVisibility(m1, m2, t, settings.minVariance * slope * slope,
                             settings.bleedReduction, record);
}

// The visibility from P1 P2 and, with a second warp, N1 N2: the smaller of their bounds.
template <class Record>
double visibilityOf(std::span<const double> channels, const WarpSettings& settings, double receiver,
                    const Record& record) {
  record("z_r", "receiver's depth, biased", "", receiver);
  const double rising = boundOfWarp(channels[0], channels[1], settings.positiveExponent, receiver,
                                    settings, record.withSuffix("₊"));
  if (settings.negativeExponent == 0.0) return record("v", "visibility", "v₊", rising);
  const double mirrored = boundOfWarp(channels[2], channels[3], -settings.negativeExponent,
                                      receiver, settings, record.withSuffix("₋"));
  return record("v",
                rising <= mirrored ? "the rising warp's bound is the sharper one"
                                   : "the mirrored warp's bound is the sharper one",
                "min(v₊, v₋)", std::min(rising, mirrored));
}

// `steeper` is the technique with the exponents that were asked for, before the format cut them
// down.
Trace explainWarps(const Technique& technique, const WarpSettings& settings,
                   const Technique& steeper, const WarpSettings& asked, const Fetch& fetch,
                   double receiver);

}  // namespace umbra::evsm
