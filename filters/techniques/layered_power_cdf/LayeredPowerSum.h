// The visibility of layered power functions, step by step (Gumbau et al. 2011, §5).
#pragma once

#include <span>

#include "filters/techniques/lvsm/Layers.h"
#include "filters/techniques/power_cdf/PowerVisibility.h"

namespace umbra::layered_power_cdf {

// The visibility in layer i, from 0. Channels are L1mean L1min L1max L2mean …; `record` takes the
// steps.
template <class Record>
double layerVisibility(const Layering& layers, int i, std::span<const double> channels,
                       double receiver, const Record& record) {
  record("p", "where the layer begins", "", layers.low(i));
  record("q", "where it ends", "", layers.high(i));
  const double place = record("φ", "receiver's place in the layer, as its z_r",
                              "clamp((z_r − p)/(q − p), 0, 1)", layers.warp(i, receiver));
  return powerVisibility(channels[3 * i], channels[3 * i + 1], channels[3 * i + 2], place, record);
}

// The steps of a layer are numbered from 1.
template <class Record>
double visibilityOf(const Layering& layers, std::span<const double> channels, double receiver,
                    const Record& record) {
  record("z_r", "receiver's depth, biased", "", receiver);
  const double visibility = layers.blended(receiver, [&](int i) {
    return layerVisibility(layers, i, channels, receiver, record.numbered(i + 1));
  });
  return record("v", "visibility in the receiver's layer", "blended where two overlap", visibility);
}

}  // namespace umbra::layered_power_cdf
