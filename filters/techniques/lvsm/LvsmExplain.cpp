// Which step of a layered variance estimate goes wrong.
#include <string>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Text.h"
#include "filters/techniques/lvsm/Lvsm.h"
#include "filters/techniques/lvsm/LvsmSum.h"
#include "filters/techniques/vsm/VarianceErrors.h"
#include "filters/techniques/vsm/Vsm.h"

namespace umbra::lvsm {
namespace {

// The layer whose visibility counts most, from 0.
int mainLayer(const Layering& layers, double receiver) {
  int main = 0;
  while (main + 1 < layers.count && receiver > layers.bounds[main + 1]) ++main;
  return main;
}

double plainVisibility(std::span<const double> moments, double receiver) {
  return chebyshevVisibility(moments[0], moments[1], receiver, 0.0, 0.0, Unrecorded());
}

const std::string whyBright =
    "Within the layer their variance is large beside the receiver's distance, and the bound "
    "cannot tell them from depths behind the receiver.";

}  // namespace

Trace Lvsm::explain(const Fetch& fetch, double receiver) const {
  const Layering layers = layering();
  Trace trace;
  visibilityOf(layers, fetch.channels, values.minVariance, values.bleedReduction, receiver,
               TraceRecorder(trace));
  const int layer = mainLayer(layers, receiver);
  ErrorShares shares(trace, fetch, receiver, TraceRecorder::numberText(layer + 1));
  const auto evaluate = [&](std::span<const double> channels, const BoundSettings& heeded) {
    return visibilityOf(layers, channels, heeded.minVariance ? values.minVariance : 0.0,
                        heeded.reduction ? values.bleedReduction : 0.0, receiver, Unrecorded());
  };
  const std::vector<double> exact = chargeSettings(shares, *this, fetch, evaluate);
  const double layered = evaluate(exact, {false, false});
  // The same region with depth in one layer.
  const vsm::Vsm whole;
  const std::vector<double> moments = prefilteredRegion(fetch.region, whole, StorageFormat::Double);
  const double unlayered = plainVisibility(moments, receiver);
  if (unlayered < layered) {
    shares.without(ErrorCause::LayerCut, "t", unlayered,
                   "the layer holds depths from " + shortNumber(layers.low(layer)) + " to " +
                       shortNumber(layers.high(layer)) +
                       " and moves all others to its ends, which "
                       "brings the occluders, at " +
                       rangeText(shares.occlusion().blocking) +
                       ", nearer to the receiver; in one piece v would be " +
                       shortNumber(unlayered) + ".");
    chargeSpread(shares, plainVisibility(withoutSpread(whole, fetch.region, receiver), receiver),
                 receiver <= moments[0], receiver, ErrorCause::DistantVariance, whyBright);
  } else {
    const bool early = layers.warp(layer, receiver) <= exact[2 * layer];
    chargeSpread(shares, evaluate(withoutSpread(*this, fetch.region, receiver), {false, false}),
                 early, receiver, ErrorCause::DistantVariance, whyBright);
  }
  shares.decide("in the receiver's layer there are nearly two depths only.");
  return trace;
}

}  // namespace umbra::lvsm
