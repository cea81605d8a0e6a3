// What goes wrong in a Chebyshev bound, whatever the warp: common to vsm, evsm and lvsm.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "filters/core/prefilter/ErrorShares.h"

namespace umbra {

// Which settings an evaluation applies.
struct BoundSettings {
  bool reduction = true;
  bool minVariance = true;
};
// Evaluates the visibility from other channels than the fetch's, or without some settings.
using BoundEvaluation =
    std::function<double(std::span<const double> channels, const BoundSettings&)>;

// Takes away the reduction, then the rounding of the channels, then the smallest variance. Returns
// the channels in double.
std::vector<double> chargeSettings(ErrorShares& shares, const Technique& technique,
                                   const Fetch& fetch, const BoundEvaluation& evaluate);

// The channels, pairs of moments, if all blocking depths lay at their mean in each warp: then only
// the variance between the blocking and the lit depths is left.
std::vector<double> withoutSpread(const Technique& technique, const Region& region,
                                  double receiver);

// Takes the spread of the blocking depths away, and charges early-out or slack with the rest.
// `early` says that the receiver counts as lit because it is not behind the mean.
void chargeSpread(ErrorShares& shares, double visibilityWithoutSpread, bool early, double receiver,
                  ErrorCause cause, const std::string& whyBright);

// Describes the region's blocking depths: "occluders lie at 0.2 … 0.6, the receiver 0.15 behind the
// last of them".
std::string occludersText(const Occlusion& occlusion, double receiver);

}  // namespace umbra
