#include "ui/window/files/RawDepthPlot.h"

#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

constexpr const char* barColour = "#3f6fb5";
constexpr const char* rangeColour = "#dde9da";
constexpr const char* boundColour = "#52606d";
constexpr double lineOfBars = 1.2;  // points

// As wide as the values lie; a single value gets a width that can be seen.
std::vector<double> edgesOf(const RawDepths& raw) {
  double low = raw.low, high = raw.high;
  if (low == high) {
    const double half = std::max(std::abs(low), 1.0) / 200.0;
    low -= half;
    high += half;
  }
  std::vector<double> edges;
  for (int i = 0; i <= RawDepths::bins; ++i)
    edges.push_back(std::lerp(low, high, double(i) / RawDepths::bins));
  return edges;
}

}  // namespace

Plot rawDepthPlot(const RawDepths& raw, const DepthImport& import) {
  Plot plot{.name = "file-values",
            .title = "Values in the file",
            .xLabel = "value in the file",
            .yLabel = "log10(1 + texels)"};
  PlotSeries bars{"texels", barColour, SeriesStyle::Bars, edgesOf(raw), {}, lineOfBars};
  for (std::size_t count : raw.counts) bars.y.push_back(std::log10(1.0 + double(count)));
  const double low = std::min({bars.x.front(), import.atZero, import.atOne}),
               high = std::max({bars.x.back(), import.atZero, import.atOne});
  const double margin = 0.02 * (high - low);
  plot.xRange = PlotRange{low - margin, high + margin};
  plot.yRange = PlotRange{0.0, 1.05 * *std::max_element(bars.y.begin(), bars.y.end())};
  plot.bands.push_back({std::min(import.atZero, import.atOne),
                        std::max(import.atZero, import.atOne), "read as depth", rangeColour});
  plot.series.push_back(std::move(bars));
  plot.markers.push_back({MarkerAxis::Vertical, import.atZero, "0", boundColour});
  plot.markers.push_back({MarkerAxis::Vertical, import.atOne, "1", boundColour});
  return plot;
}

}  // namespace umbra
