// The depths of the whole map beside those of one region.
#pragma once

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

struct MapHistogramOptions {
  int bins = 60;  // ≥ 1, of equal width over [0,1]
  // y is log10(1 + count), which shows one texel among a million and is 0 for an empty bin;
  // otherwise y is the share of the texels.
  bool logarithmic = true;
  // Whether the region's taps are also shown weighted by the kernel, as the same number of taps in
  // all.
  bool kernelWeights = true;
};

// Shows every depth of the map, with all samples of its texels, and every tap of the probe's
// region.
Plot mapHistogramPlot(const DepthMap& map, const Probe& probe,
                      const MapHistogramOptions& options = {});

}  // namespace umbra
