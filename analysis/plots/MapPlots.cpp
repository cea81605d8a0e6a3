#include "analysis/plots/MapPlots.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"

namespace umbra {
namespace {

constexpr std::string_view mapColour = "#9aa5b1";
constexpr std::string_view weightColour = "#0f8b8d";

// The bin of a depth in [0,1]; the last one is closed.
std::size_t binOf(double depth, int bins) {
  return std::size_t(std::clamp(int(std::floor(depth * bins)), 0, bins - 1));
}

// Counts as heights: logarithms, or shares of `total`.
std::vector<double> heights(std::vector<double> counts, double total, bool logarithmic) {
  for (double& count : counts)
    count = logarithmic ? std::log10(1.0 + count) : (total > 0.0 ? count / total : 0.0);
  return counts;
}

PlotSeries outline(std::string name, std::string_view colour, const std::vector<double>& edges,
                   std::vector<double> counts) {
  counts.push_back(counts.back());  // the last bin reaches to its far edge
  PlotSeries series{std::move(name), std::string(colour), SeriesStyle::Steps, edges,
                    std::move(counts)};
  series.lineWidth = plot::normal;
  return series;
}

}  // namespace

Plot mapHistogramPlot(const DepthMap& map, const Probe& probe, const MapHistogramOptions& options) {
  std::vector<double> edges, ofMap(options.bins, 0.0), ofRegion = ofMap, weighted = ofMap;
  for (int i = 0; i <= options.bins; ++i) edges.push_back(double(i) / options.bins);
  for (double depth : map.values()) ofMap[binOf(depth, options.bins)] += 1.0;
  const double taps = double(probe.region.texels.size());
  for (const RegionTexel& texel : probe.region.texels) {
    ofRegion[binOf(texel.depth, options.bins)] += 1.0;
    weighted[binOf(texel.depth, options.bins)] += texel.weight * taps;
  }
  Plot plot{.name = "map-histogram",
            .title = "Depths of the whole map and of the region",
            .xLabel = plot::depthLabel(),
            .yLabel = options.logarithmic ? "log₁₀(1 + texels in the bin)" : "share of the texels",
            .xRange = PlotRange{0.0, 1.0}};
  plot.series.push_back(
      {"whole map", std::string(mapColour), SeriesStyle::Bars, edges,
       heights(std::move(ofMap), double(map.values().size()), options.logarithmic)});
  plot.series.push_back(outline("region", depthColour, edges,
                                heights(std::move(ofRegion), taps, options.logarithmic)));
  if (options.kernelWeights)
    plot.series.push_back(outline("region, weighted by the kernel", weightColour, edges,
                                  heights(std::move(weighted), taps, options.logarithmic)));
  double highest = 0.0;
  for (const PlotSeries& series : plot.series)
    highest = std::max(highest, *std::max_element(series.y.begin(), series.y.end()));
  plot.yRange = PlotRange{0.0, 1.05 * highest};
  plot.markers.push_back(plot::receiverMarker(probe.receiver));
  return plot;
}

}  // namespace umbra
