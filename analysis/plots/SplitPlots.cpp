#include "analysis/plots/SplitPlots.h"

#include <algorithm>
#include <string>

#include "analysis/plots/ProbePlots.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

constexpr std::string_view splitColour = "#7b4fa3", uniformColour = "#6b7785";

// A bin of width 0 could not be seen.
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

Plot layersPlot(const Histogram& histogram, std::span<const double> splits, double overlap,
                std::span<const std::string> colours) {
  Plot plot = splitsPlot(histogram, splits);
  plot.name = "layers";
  for (PlotMarker& marker : plot.markers) marker.draggable = true;
  std::vector<double> bounds{0.0};
  bounds.insert(bounds.end(), splits.begin(), splits.end());
  bounds.push_back(1.0);
  const std::size_t layers = bounds.size() - 1;
  for (std::size_t i = 0; i < layers; ++i) {
    // The interval that the layer's warp covers is wider than the one that the layer decides.
    const double low = i == 0 ? 0.0 : bounds[i] - overlap;
    const double high = i + 1 == layers ? 1.0 : bounds[i + 1] + overlap;
    plot.bands.push_back(
        {bounds[i], bounds[i + 1],
         "layer " + std::to_string(i + 1) + " covers " + shortNumber(low) + "–" + shortNumber(high),
         colours[i % colours.size()]});
  }
  if (overlap <= 0.0) return plot;
  for (std::size_t k = 0; k < splits.size(); ++k)
    plot.bands.push_back({splits[k] - overlap, splits[k] + overlap,
                          "layers " + std::to_string(k + 1) + " and " + std::to_string(k + 2) +
                              " blended, δ = " + shortNumber(overlap),
                          std::string(splitColour), true});
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

Plot costPlot(std::span<const double> cost, double uniform, std::size_t shown) {
  Plot plot = costPlot(cost);
  if (shown < cost.size())
    plot.series.push_back(
        {"", std::string(splitColour), SeriesStyle::Points, {double(shown)}, {cost[shown]}});
  plot.markers.push_back({MarkerAxis::Horizontal, uniform, "uniform", std::string(uniformColour)});
  if (uniform > 0.0) plot.yRange->high = std::max(plot.yRange->high, 1.08 * uniform);
  return plot;
}

}  // namespace umbra
