#include "analysis/SplitPlots.h"

#include <algorithm>
#include <string>

#include "analysis/ProbePlots.h"

namespace umbra {
namespace {

constexpr std::string_view splitColour = "#7b4fa3";

// A bin without width could not be seen.
std::vector<double> visibleEdges(const Histogram& histogram) {
  std::vector<double> edges = histogram.edges;
  if (edges.size() == 2 && edges[0] == edges[1]) {
    edges[0] -= 0.005;
    edges[1] += 0.005;
  }
  return edges;
}

}  // namespace

Plot splitsPlot(const Histogram& histogram, std::span<const double> splits) {
  Plot plot{.name = "splits",
            .title = "Second occluders of the map · " + std::to_string(splits.size() + 1) +
                     (splits.empty() ? " layer" : " layers"),
            .xLabel = "light-space depth μ + σ (normalised)",
            .yLabel = "share of variance",
            .xRange = PlotRange{0.0, 1.0},
            .yRange = PlotRange{0.0, 1.0}};
  if (!histogram.weights.empty()) {
    // The second occluder lies a little beyond the far plane where σ is large.
    plot.xRange->high = std::max(1.0, histogram.edges.back());
    plot.yRange->high =
        1.05 * *std::max_element(histogram.weights.begin(), histogram.weights.end());
    plot.series.push_back({"second occluders", std::string(depthColour), SeriesStyle::Bars,
                           visibleEdges(histogram), histogram.weights});
  }
  for (std::size_t k = 0; k < splits.size(); ++k)
    plot.markers.push_back({MarkerAxis::Vertical, splits[k], "s" + std::to_string(k + 1),
                            std::string(splitColour), false});
  return plot;
}

Plot costPlot(std::span<const double> cost) {
  Plot plot{.name = "cost",
            .title = "Cost of the splits",
            .xLabel = "iteration",
            .yLabel = "mean squared distance (depth²)",
            .wholeX = true};
  PlotSeries series{"cost", std::string(splitColour), SeriesStyle::Line};
  for (std::size_t i = 0; i < cost.size(); ++i) {
    series.x.push_back(double(i));
    series.y.push_back(cost[i]);
  }
  const double highest = cost.empty() ? 0.0 : *std::max_element(cost.begin(), cost.end());
  plot.xRange = PlotRange{0.0, std::max(1.0, double(cost.size()) - 1.0)};
  plot.yRange = PlotRange{0.0, highest > 0.0 ? 1.08 * highest : 1.0};
  plot.series.push_back(std::move(series));
  return plot;
}

}  // namespace umbra
