#include "ui/widgets/plots/PlotReadout.h"

#include <algorithm>
#include <cmath>

#include "filters/core/support/Text.h"

namespace umbra {
namespace {

bool holds(const PlotSeries& series) {
  return !series.y.empty() && series.x.size() >= series.y.size();
}

std::optional<double> nearestPoint(const PlotSeries& series, double x) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < series.y.size(); ++i)
    if (std::abs(series.x[i] - x) < std::abs(series.x[best] - x)) best = i;
  return series.y[best];
}

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

}  // namespace

std::optional<double> seriesValueAt(const PlotSeries& series, double x) {
  if (!holds(series)) return std::nullopt;
  if (series.style == SeriesStyle::Points) return nearestPoint(series, x);
  if (!(x >= series.x.front()) || x > series.x.back()) return std::nullopt;

  const auto after = std::upper_bound(series.x.begin(), series.x.end(), x);
  const std::size_t left = std::size_t(after - series.x.begin()) - 1;
  const std::size_t last = series.y.size() - 1;
  if (left >= last || series.style != SeriesStyle::Line) return series.y[std::min(left, last)];

  const double part = (x - series.x[left]) / (series.x[left + 1] - series.x[left]);
  return series.y[left] + part * (series.y[left + 1] - series.y[left]);
}

std::string readoutAt(const Plot& plot, double x) {
  std::string text = "<table cellspacing='0'><tr><td>" + escaped(plot.xLabel) +
                     "&nbsp;&nbsp;</td><td align='right'>" + shortNumber(x) + "</td></tr>";
  for (const PlotSeries& series : plot.series) {
    const std::optional<double> y = seriesValueAt(series, x);
    if (!y || series.name.empty()) continue;
    text += "<tr><td style='color:" + series.colour + "'>" + escaped(series.name) +
            "&nbsp;&nbsp;</td><td align='right'>" + shortNumber(*y) + "</td></tr>";
  }
  for (const PlotBand& band : plot.bands)
    if (!band.name.empty() && x >= band.low && x <= band.high)
      text += "<tr><td colspan='2'>" + escaped(band.name) + "</td></tr>";
  return text + "</table>";
}

}  // namespace umbra
