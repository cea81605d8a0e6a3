#include "filters/techniques/power_cdf/PowerErrors.h"

#include <algorithm>

#include "filters/core/support/Text.h"
#include "filters/techniques/power_cdf/PowerVisibility.h"

namespace umbra {
namespace {

// Depths behind the receiver by at most this part of the region's range belong to its own surface.
constexpr double ownSurface = 0.05;
// Counting the own surface apart explains a penumbra that has collapsed where it brings the
// visibility back to the reference, or above it by at most this.
constexpr double largestExcess = 0.02;

struct Fit {
  double weight = 0.0, sum = 0.0;
  double min = 0.0, max = 0.0;

  void add(double depth, double w) {
    min = weight == 0.0 ? depth : std::min(min, depth);
    max = weight == 0.0 ? depth : std::max(max, depth);
    weight += w;
    sum += w * depth;
  }
  double visibility(double receiver) const {
    return weight > 0.0 ? powerVisibility(sum / weight, min, max, receiver) : 0.0;
  }
};

// The visibility if the receiver's own surface counted as lit and only the other depths were
// fitted.
double withOwnSurfaceApart(const Region& region, double receiver,
                           const std::function<double(double)>& warp, double range) {
  const double reach = warp(receiver) + ownSurface * range;
  Fit others;
  double own = 0.0;
  for (const RegionTexel& texel : region.texels) {
    if (texel.weight <= 0.0) continue;
    if (texel.depth >= receiver && warp(texel.depth) <= reach)
      own += texel.weight;
    else
      others.add(warp(texel.depth), texel.weight);
  }
  return own + (1.0 - own) * others.visibility(warp(receiver));
}

}  // namespace

void chargePower(ErrorShares& shares, double mean, double min, double max, const Region& region,
                 double receiver, const std::function<double(double)>& warp) {
  Fit exact;
  for (const RegionTexel& texel : region.texels)
    if (texel.weight > 0.0) exact.add(warp(texel.depth), texel.weight);
  const double t = warp(receiver);
  const double precise = powerVisibility(exact.sum / exact.weight, min, max, t);
  shares.without(ErrorCause::StoredPrecision, "z̄", precise,
                 "the stored mean, " + shortNumber(mean) +
                     ", is rounded; from an exact one v "
                     "would be " +
                     shortNumber(precise) + ".");
  const bool early = t <= std::clamp(exact.sum / exact.weight, min, max);
  if (!early && max > t - ownSurface * (max - min)) {
    const double apart = withOwnSurfaceApart(region, receiver, warp, max - min);
    if (apart > precise && apart <= shares.reference() + largestExcess)
      shares.without(ErrorCause::CollapsedPenumbra, "max", apart,
                     "the receiver is a surface at the region's farthest depth, where a power "
                     "function leaves nothing behind it: its penumbra collapses to full shadow. "
                     "Counted apart, that surface would give " +
                         shortNumber(apart) + ".");
  }
  const std::string blocking = shortNumber(shares.occlusion().blocking.weight);
  if (early)
    shares.rest(ErrorCause::EarlyOut, "v",
                "a receiver that is not behind the mean counts as lit, though " + blocking +
                    " of the region blocks.");
  else
    shares.rest(ErrorCause::Misfit, "β",
                "the depths are not distributed as t^β: " + blocking +
                    " of them lie before the receiver, at " +
                    rangeText(shares.occlusion().blocking) +
                    ", where the fitted function has "
                    "others.");
}

}  // namespace umbra
