// The values of a depth file as a plot.
#pragma once

#include "analysis/plots/Plot.h"
#include "datasets/maps/DepthFile.h"
#include "datasets/maps/RawDepths.h"

namespace umbra {

// Shows the counted values on a logarithmic scale, with the range that is read as depth.
Plot rawDepthPlot(const RawDepths& raw, const DepthImport& import);

}  // namespace umbra
