// What an error costs to avoid.
#pragma once

#include <span>
#include <string>

#include "analysis/plots/Plot.h"

namespace umbra {

// A technique, or one of its settings, over a frame.
struct CostPoint {
  std::string name;           // for the legend
  std::string colour;         // "#rrggbb"
  double milliseconds = 0.0;  // of bake and shade
  double rmse = 0.0;          // of the visibility
};

// A mark for each point, and as a staircase the least error that each cost buys: the Pareto front.
Plot errorAgainstCostPlot(std::span<const CostPoint> points);

}  // namespace umbra
