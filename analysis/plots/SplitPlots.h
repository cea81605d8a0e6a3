// Where layers are split, and how the splits came there, as plots.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// The weighted second-occluder depths of a map (Lauritzen 2008, §4.1.3) as bars, with every split
// marked. An empty histogram gives the markers alone.
Plot splitsPlot(const Histogram& histogram, std::span<const double> splits);

// The same, with the layers that the splits cut [0,1] into as bands, in `colours` ("#rrggbb") from
// the light outwards, in turn. The zones of half width `overlap` (δ, depth) in which two layers are
// blended are hatched. Splits can be dragged.
Plot layersPlot(const Histogram& histogram, std::span<const double> splits, double overlap,
                std::span<const std::string> colours);

// Shows the weighted squared distance to the nearest split, depth², as each iteration found it; the
// first value is the one before any move.
Plot costPlot(std::span<const double> cost);
// The same beside the cost of uniform splits; iteration `shown` is marked.
Plot costPlot(std::span<const double> cost, double uniform, std::size_t shown);

}  // namespace umbra
