// Plots of a probe.
#pragma once

#include <string_view>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// Colours with one meaning throughout the program.
inline constexpr std::string_view probeColour = "#f59e0b";      // the probe and its receiver
inline constexpr std::string_view errorColour = "#d1344b";      // error, and nothing else
inline constexpr std::string_view referenceColour = "#1f2933";  // exact percentage-closer filtering
inline constexpr std::string_view depthColour = "#3f6fb5";      // depths of the region
inline constexpr std::string_view powerColour = "#7b4fa3";      // Gumbau's fit
inline constexpr std::string_view chebyshevColour = "#2563c9";  // Lauritzen's bound

// Shows depths of the region as bars; receiver, mean, min and max are marked.
Plot histogramPlot(const Probe& probe, int bins = 60);

// Shows v(z) of every technique and of the reference, over depth. The error of technique `selected`
// (an id) at the receiver is marked and its curve emphasised.
Plot curvesPlot(const Probe& probe, std::string_view selected, int samples = 401);

// Shows the cumulative distribution: exact steps, the fitted t^β (Gumbau 2011, eq. 2) and the
// Chebyshev bound 1 − p_max (Lauritzen 2008, eq. 3.3).
Plot cdfPlot(const Probe& probe);

}  // namespace umbra
