// The power function that power CDF shadow maps fit to a region's depths, in plots.
#pragma once

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// F(z) = t^β with t = (z − min)/(max − min) (Gumbau 2011, eq. 2); it is 0 up to min, and 1 from max
// on. For β = 0 or ∞, and where the region has one depth, it is a step.
double powerCdf(const RegionStatistics& statistics, double z);

// Power functions t^β of β = ½, 1, 2, 5 (Gumbau 2011, fig. 1) and of the region's β (eq. 3), with
// the region's own distribution over t in [0,1].
Plot powerFamilyPlot(const Probe& probe);

// Plots the fitted minus the exact distribution over depth, with both ends of every jump of the
// exact one. The largest difference is marked.
Plot residualPlot(const Probe& probe);

}  // namespace umbra
