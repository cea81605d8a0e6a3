// The depths of the whole map beside those of one region.
#pragma once

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

struct MapHistogramOptions {
  int bins = 60;  // ≥ 1, of equal width over [0,1]
  // y is log10(1 + count), in which one texel of a million is still seen and an empty bin is 0;
  // else the share of the texels.
  bool logarithmic = true;
  // Also the region's taps weighted by the kernel, as so many taps in all.
  bool kernelWeights = true;
};

// Every depth of the map, all samples of its texels, and every tap of the probe's region.
Plot mapHistogramPlot(const DepthMap& map, const Probe& probe,
                      const MapHistogramOptions& options = {});

}  // namespace umbra
