// Where layers are split, and how the splits came there, as plots.
#pragma once

#include <span>

#include "analysis/Plot.h"
#include "analysis/Probe.h"

namespace umbra {

// The weighted second-occluder depths of a map (Lauritzen 2008, §4.1.3) as bars, with every split
// marked. An empty histogram gives the markers alone.
Plot splitsPlot(const Histogram& histogram, std::span<const double> splits);

// The weighted squared distance to the nearest split, depth², as each iteration found it; the
// first value is that before any move.
Plot costPlot(std::span<const double> cost);

}  // namespace umbra
