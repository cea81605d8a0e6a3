#include "filters/core/prefilter/ErrorShares.h"

#include <algorithm>
#include <cmath>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Text.h"
#include "filters/core/technique/VisibleError.h"

namespace umbra {
namespace {

void add(DepthGroup& group, const RegionTexel& texel) {
  const bool first = group.weight == 0.0;
  group.weight += texel.weight;
  group.mean += texel.weight * texel.depth;
  group.min = first ? texel.depth : std::min(group.min, texel.depth);
  group.max = first ? texel.depth : std::max(group.max, texel.depth);
}

}  // namespace

Occlusion occlusionOf(const Region& region, double receiver) {
  Occlusion occlusion;
  for (const RegionTexel& texel : region.texels)
    if (texel.weight > 0.0) add(texel.depth < receiver ? occlusion.blocking : occlusion.lit, texel);
  for (DepthGroup* group : {&occlusion.blocking, &occlusion.lit})
    if (group->weight > 0.0)
      group->mean = std::clamp(group->mean / group->weight, group->min, group->max);
  return occlusion;
}

std::string rangeText(const DepthGroup& group) {
  const std::string low = shortNumber(group.min), high = shortNumber(group.max);
  return low == high ? low : low + " … " + high;
}

ErrorShares::ErrorShares(Trace& trace, const Fetch& fetch, double receiver, std::string suffix)
    : trace_(trace),
      suffix_(std::move(suffix)),
      visibility_(trace.steps.back().value),
      reference_(referenceVisibility(fetch.region, receiver)),
      left_(visibility_),
      occlusion_(occlusionOf(fetch.region, receiver)) {}

void ErrorShares::without(ErrorCause cause, std::string_view symbol, double visibility,
                          std::string sentence) {
  trace_.shares.push_back({cause, stepOf(symbol), left_ - visibility});
  sentences_.push_back(std::move(sentence));
  left_ = visibility;
}

int ErrorShares::stepOf(std::string_view symbol) const {
  const int last = int(trace_.steps.size()) - 1;
  for (const std::string& wanted : {std::string(symbol) + suffix_, std::string(symbol)})
    for (int i = last; i >= 0; --i)
      if (trace_.steps[i].symbol == wanted) return i;
  return last;
}

void ErrorShares::rest(ErrorCause cause, std::string_view symbol, std::string sentence) {
  without(cause, symbol, reference_, std::move(sentence));
}

void ErrorShares::decide(std::string_view whyRight) {
  const double error = visibility_ - reference_;
  if (!isVisibleError(error)) {
    trace_.cause = ErrorCause::None;
    std::string why(whyRight);
    if (occlusion_.blocking.weight == 0.0)
      why = "nothing in the region lies before the receiver.";
    else if (occlusion_.lit.weight == 0.0)
      why = "the whole region blocks, and the estimate has fallen off behind it.";
    trace_.sentence = "Right: " + shortNumber(visibility_) + ", the reference is " +
                      shortNumber(reference_) + "; " + why;
    return;
  }
  const auto against = [&](const ErrorShare& share) {
    return std::copysign(1.0, error) * share.amount;
  };
  const auto worst = std::max_element(
      trace_.shares.begin(), trace_.shares.end(),
      [&](const ErrorShare& a, const ErrorShare& b) { return against(a) < against(b); });
  trace_.cause = worst->cause;
  trace_.culprit = worst->step;
  trace_.sentence = verdict(error, sentences_[worst - trace_.shares.begin()], worst->amount);
}

std::string ErrorShares::verdict(double error, const std::string& sentence, double amount) const {
  std::string text = std::string(error > 0.0 ? "Too bright" : "Too dark") + " by " +
                     shortNumber(std::abs(error)) + " (" + shortNumber(visibility_) +
                     ", the reference is " + shortNumber(reference_) + "): " + sentence;
  // Other causes may undo a part of this share, so that it can be larger than the error.
  if (std::abs(amount - error) > 0.05 * std::abs(error))
    text += " This makes " + shortNumber(std::abs(amount)) + " of it.";
  return text;
}

std::vector<double> exactMeans(const Technique& technique, const Fetch& fetch) {
  std::vector<double> channels = prefilteredRegion(fetch.region, technique, StorageFormat::Double);
  const std::vector<Channel> layout = technique.channels();
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (layout[c].reduction != Reduction::Mean) channels[c] = fetch.channels[c];
  return channels;
}

}  // namespace umbra
