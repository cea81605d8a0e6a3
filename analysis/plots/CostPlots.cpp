#include "analysis/plots/CostPlots.h"

#include <algorithm>
#include <vector>

#include "analysis/cost/ParetoFront.h"
#include "analysis/plots/PlotParts.h"

namespace umbra {
namespace {

constexpr const char* frontColour = "#6b7785";
constexpr double room = 1.08;  // the farthest point is not on the plot's edge

// It ends at the plot's edge: more cost than that of the last point buys no less error.
PlotSeries frontOf(std::span<const CostPoint> points, double end) {
  std::vector<CostAndError> choices;
  for (const CostPoint& point : points) choices.push_back({point.milliseconds, point.rmse});
  PlotSeries front{.name = "least error for the cost",
                   .colour = frontColour,
                   .style = SeriesStyle::Steps,
                   .lineWidth = plot::thin};
  for (const std::size_t i : paretoFront(choices)) {
    front.x.push_back(choices[i].cost);
    front.y.push_back(choices[i].error);
  }
  if (front.x.empty()) return front;
  front.x.push_back(end);
  front.y.push_back(front.y.back());
  return front;
}

}  // namespace

Plot errorAgainstCostPlot(std::span<const CostPoint> points) {
  double cost = 0.0, error = 0.0;
  for (const CostPoint& point : points) {
    cost = std::max(cost, point.milliseconds);
    error = std::max(error, point.rmse);
  }
  Plot plot{.name = "error-against-cost",
            .title = "Error against cost",
            .xLabel = "bake and shade (ms)",
            .yLabel = "RMSE of visibility",
            .xRange = PlotRange{0.0, cost > 0.0 ? room * cost : 1.0},
            .yRange = PlotRange{0.0, error > 0.0 ? room * error : 1.0}};
  plot.series.push_back(frontOf(points, plot.xRange->high));
  for (const CostPoint& point : points)
    plot.series.push_back({.name = point.name,
                           .colour = point.colour,
                           .style = SeriesStyle::Points,
                           .x = {point.milliseconds},
                           .y = {point.rmse}});
  return plot;
}

}  // namespace umbra
