// What a probe shows, as plots.
#pragma once

#include <string_view>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

// Colours with one meaning throughout the program.
inline constexpr std::string_view probeColour = "#f59e0b";      // the probe and its receiver
inline constexpr std::string_view errorColour = "#d1344b";      // error, and nothing else
inline constexpr std::string_view referenceColour = "#1f2933";  // the truth
inline constexpr std::string_view depthColour = "#3f6fb5";      // depths of the region

// Depths of the region as bars, with receiver, mean, min and max marked.
Plot histogramPlot(const Probe& probe, int bins = 60);

// v(z) of every technique and the reference, over depth; the error of technique `selected` (an id)
// at the receiver is marked and its curve emphasised.
Plot curvesPlot(const Probe& probe, std::string_view selected, int samples = 401);

// The cumulative distribution: exact steps, the fitted t^β (Gumbau 2011, eq. 2) and the Chebyshev
// bound 1 − p_max (Lauritzen 2008, eq. 3.3).
Plot cdfPlot(const Probe& probe);

}  // namespace umbra
