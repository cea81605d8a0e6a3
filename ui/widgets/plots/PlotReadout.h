// The figures under the cursor of a plot.
#pragma once

#include <optional>
#include <string>

#include "analysis/plots/Plot.h"

namespace umbra {

// The y of a series at x as it is drawn: between points for lines, held for steps and bars, the
// nearest for points. None outside its x.
std::optional<double> seriesValueAt(const PlotSeries& series, double x);

// "z 0.7800" and a line for each named series that has a value there, as rich text in its colour.
std::string readoutAt(const Plot& plot, double x);

}  // namespace umbra
