// Which step of a layered power function goes wrong.
#include <cmath>
#include <utility>
#include <vector>

#include "filters/core/support/Text.h"
#include "filters/techniques/layered_power_cdf/LayeredPowerCdf.h"
#include "filters/techniques/layered_power_cdf/LayeredPowerSum.h"
#include "filters/techniques/power_cdf/PowerErrors.h"

namespace umbra::layered_power_cdf {

Trace LayeredPowerCdf::explain(const Fetch& fetch, double receiver) const {
  const Layering layers = layering();
  Trace trace;
  visibilityOf(layers, fetch.channels, receiver, TraceRecorder(trace));
  int layer = 0;
  while (layer + 1 < layers.count && receiver > layers.bounds[layer + 1]) ++layer;
  ErrorShares shares(trace, fetch, receiver, TraceRecorder::numberText(layer + 1));
  const auto alone = layerVisibility(layers, layer, fetch.channels, receiver, Unrecorded());
  shares.without(ErrorCause::LayerCut, "v", alone,
                 "near the split two layers are blended; the receiver's own gives " +
                     shortNumber(alone) + ".");
  // The same region with depth in one layer.
  const RegionStatistics s = statisticsOf(fetch.region);
  const double whole = powerVisibility(s.mean, s.min, s.max, receiver);
  if (std::abs(whole - shares.reference()) < std::abs(alone - shares.reference())) {
    shares.without(ErrorCause::LayerCut, "φ", whole,
                   "the layer holds depths from " + shortNumber(layers.low(layer)) + " to " +
                       shortNumber(layers.high(layer)) +
                       " and moves all others to its ends, where they gather; in one piece v "
                       "would be " +
                       shortNumber(whole) + ".");
    chargePower(shares, s.mean, s.min, s.max, fetch.region, receiver, [](double z) { return z; });
  } else {
    const double* channels = &fetch.channels[3 * layer];
    chargePower(shares, channels[0], channels[1], channels[2], fetch.region, receiver,
                [&](double z) { return layers.warp(layer, z); });
  }
  shares.decide("within the layer the depths are distributed about as t^β.");
  return trace;
}

}  // namespace umbra::layered_power_cdf
