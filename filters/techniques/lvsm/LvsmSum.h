// The visibility of layered moments, step by step (Lauritzen 2008, §4.1).
#pragma once

#include <span>

#include "filters/techniques/lvsm/Layers.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::lvsm {

// Channels are L1M1 L1M2 L2M1 …; minVariance is in unwarped depth². `record` takes the steps; those
// of a layer are numbered from 1.
template <class Record>
double visibilityOf(const Layering& layers, std::span<const double> channels, double minVariance,
                    double reduction, double receiver, const Record& record) {
  record("z_r", "receiver's depth, biased", "", receiver);
  const double visibility = layers.blended(receiver, [&](int i) {
    const auto inLayer = record.numbered(i + 1);
    inLayer("p", "where the layer begins", "", layers.low(i));
    inLayer("q", "where it ends", "", layers.high(i));
    const double t = inLayer("t", "receiver's place in the layer", "clamp((z_r − p)/(q − p), 0, 1)",
                             layers.warp(i, receiver));
    const double width = layers.high(i) - layers.low(i);
    return chebyshevVisibility(channels[2 * i], channels[2 * i + 1], t,
                               minVariance / (width * width), reduction, inLayer);
  });
  return record("v", "visibility in the receiver's layer", "blended where two overlap", visibility);
}

}  // namespace umbra::lvsm
