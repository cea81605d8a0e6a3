#include "filters/techniques/vsm/VarianceErrors.h"

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

constexpr BoundSettings withoutReduction{.reduction = false};
constexpr BoundSettings bare{.reduction = false, .minVariance = false};

}  // namespace

std::vector<double> chargeSettings(ErrorShares& shares, const Technique& technique,
                                   const Fetch& fetch, const BoundEvaluation& evaluate) {
  const double unreduced = evaluate(fetch.channels, withoutReduction);
  shares.without(ErrorCause::Reduction, "v", unreduced,
                 "the light-bleeding reduction takes a part of every penumbra; the bound itself "
                 "is " +
                     shortNumber(unreduced) + ".");
  const std::vector<double> exact = exactMeans(technique, fetch);
  const double precise = evaluate(exact, withoutReduction);
  shares.without(ErrorCause::StoredPrecision, "σ²", precise,
                 "the stored moments are rounded, and their difference is left with few digits; "
                 "from exact moments v would be " +
                     shortNumber(precise) + ".");
  const double unclamped = evaluate(exact, bare);
  shares.without(ErrorCause::VarianceClamp, "σ²₊", unclamped,
                 "the depths vary less than the smallest variance, which stands in for theirs; "
                 "without it v would be " +
                     shortNumber(unclamped) + ".");
  return exact;
}

std::vector<double> withoutSpread(const Technique& technique, const Region& region,
                                  double receiver) {
  Region blocking = region;
  std::erase_if(blocking.texels, [&](const RegionTexel& texel) { return texel.depth >= receiver; });
  std::vector<double> all = prefilteredRegion(region, technique, StorageFormat::Double);
  if (blocking.texels.empty()) return all;
  // Takes the variance of the blocking depths about their own mean out of the second moment.
  const std::vector<double> part = prefilteredRegion(blocking, technique, StorageFormat::Double);
  double weight = 0.0;
  for (const RegionTexel& texel : blocking.texels) weight += texel.weight;
  if (weight <= 0.0) return all;
  const bool alone = blocking.texels.size() == region.texels.size();
  for (std::size_t c = 0; c + 1 < all.size(); c += 2)
    all[c + 1] = alone ? all[c] * all[c] : all[c + 1] - (part[c + 1] - part[c] * part[c] / weight);
  return all;
}

void chargeSpread(ErrorShares& shares, double visibilityWithoutSpread, bool early, double receiver,
                  ErrorCause cause, const std::string& whyBright) {
  const Occlusion& occlusion = shares.occlusion();
  shares.without(cause, "σ²", visibilityWithoutSpread,
                 occludersText(occlusion, receiver) + ". " + whyBright +
                     " Were they at one depth, v would be " + shortNumber(visibilityWithoutSpread) +
                     ".");
  const std::string lit = "depths behind the receiver, at " + rangeText(occlusion.lit) + ", ";
  if (early)
    shares.rest(ErrorCause::EarlyOut, "t − μ",
                lit +
                    "draw the mean behind it too, and a receiver that is not behind the mean "
                    "counts as lit, though " +
                    shortNumber(occlusion.blocking.weight) + " of the region blocks.");
  else
    shares.rest(ErrorCause::BoundSlack, "p_max",
                lit +
                    "add to the variance and draw the mean to the receiver; only where they "
                    "all lie at the receiver is the bound reached.");
}

std::string occludersText(const Occlusion& occlusion, double receiver) {
  return "occluders lie at " + rangeText(occlusion.blocking) + ", the receiver " +
         shortNumber(receiver - occlusion.blocking.max) + " behind the last of them";
}

}  // namespace umbra
