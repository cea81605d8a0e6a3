// The power function that power CDF shadow maps fit to a region's depths, in plots.
#pragma once

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// F(z) = t^β with t = (z − min)/(max − min) (Gumbau 2011, eq. 2); it is 0 up to min, and 1 from max
// on. For β = 0 or ∞, and where the region has one depth, it is a step.
double powerCdf(const RegionStatistics& statistics, double z);

// The fit that power CDF shadow maps use at the probe: of the mean and the extremes as they are
// read, which a bilinear read interpolates between texels and a format rounds. Without a result of
// the technique it is the region's own fit. Other statistics are the region's.
RegionStatistics powerFitOf(const Probe& probe);
// Whether anybody sees the difference between the fit in use and the region's own.
bool differs(const RegionStatistics& fit, const RegionStatistics& region);

// Power functions t^β of β = ½, 1, 2, 5 (Gumbau 2011, fig. 1) and the fit in use (eq. 3), with the
// region's own distribution over t in [0,1], and with the region's own fit where it differs.
Plot powerFamilyPlot(const Probe& probe);

// Plots the fit in use minus the exact distribution over depth, with both ends of every jump of the
// exact one. The largest difference is marked.
Plot residualPlot(const Probe& probe);

}  // namespace umbra
