// Shared parts of the plots of a region.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra::plot {

inline constexpr double thin = 1.2, normal = 2.0, thick = 2.8;  // points
inline constexpr int curveSamples = 401;

std::string fixed3(double value);   // "0.250"
std::string signed3(double value);  // "+0.250", "−0.010"
std::string depthLabel();

// The short name in parentheses of a title, for legends: "Variance (VSM)" gives "VSM".
std::string legendName(const TechniqueInfo& info);

// The receiver's depth z_r.
PlotMarker receiverMarker(double receiver);

// Marks an error, unless it is too small to be seen (VisibleError.h).
void addError(Plot& plot, double x, double from, double to, std::string label);

// A range around z_r and the region's depths, with some space on both sides, within [0,1].
PlotRange rangeAround(const Probe& probe);

// Samples `function` at curveSamples points, ends included.
PlotSeries sampled(std::string name, std::string_view colour, PlotRange range,
                   const std::function<double(double)>& function);

// "#rrggbb" mixed with white: 1 is the colour itself, 0 white.
std::string tint(std::string_view colour, double share);

// The technique's numeric parameter of that name, or `otherwise` where it has none.
double parameterOf(const Technique& technique, std::string_view name, double otherwise);

}  // namespace umbra::plot
