#include "analysis/plots/PlotParts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analysis/plots/ProbePlots.h"
#include "filters/core/technique/VisibleError.h"

namespace umbra::plot {

// Three decimals are a plot's resolution; a fixed number of them keeps labels from jumping.
std::string fixed3(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3f", value);
  return buffer;
}

std::string signed3(double value) {
  return (value < 0.0 ? "−" : "+") + fixed3(std::abs(value));
}

std::string depthLabel() {
  return "light-space depth z (normalised)";
}

std::string legendName(const TechniqueInfo& info) {
  const std::string_view title = info.title;
  const std::size_t open = title.rfind('(');
  if (open == std::string_view::npos || title.back() != ')') return std::string(title);
  return std::string(title.substr(open + 1, title.size() - open - 2));
}

PlotMarker receiverMarker(double receiver) {
  return {MarkerAxis::Vertical,     receiver, "receiver z = " + fixed3(receiver),
          std::string(probeColour), true,     true};
}

void addError(Plot& plot, double x, double from, double to, std::string label) {
  if (!isVisibleError(to - from)) return;
  plot.errors.push_back({x, from, to, std::move(label), std::string(errorColour)});
}

PlotRange rangeAround(const Probe& probe) {
  const double low = std::min(probe.statistics.min, probe.receiver);
  const double high = std::max(probe.statistics.max, probe.receiver);
  const double air = std::max(0.08 * (high - low), 0.01);
  return {std::max(0.0, low - air), std::min(1.0, high + air)};
}

PlotSeries sampled(std::string name, std::string_view colour, PlotRange range,
                   const std::function<double(double)>& function) {
  PlotSeries series{std::move(name), std::string(colour)};
  for (int i = 0; i < curveSamples; ++i) {
    series.x.push_back(std::lerp(range.low, range.high, double(i) / (curveSamples - 1)));
    series.y.push_back(function(series.x.back()));
  }
  return series;
}

std::string tint(std::string_view colour, double share) {
  std::string mixed = "#";
  for (int i = 1; i < 7; i += 2) {
    const int value = std::stoi(std::string(colour.substr(i, 2)), nullptr, 16);
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", int(std::lround(std::lerp(255.0, value, share))));
    mixed += digits;
  }
  return mixed;
}

double parameterOf(const Technique& technique, std::string_view name, double otherwise) {
  for (const ParameterView& parameter : technique.parameters()) {
    if (parameter.name != name) continue;
    const ParameterValue value = parameter.get();
    if (const double* real = std::get_if<double>(&value)) return *real;
    if (const int* whole = std::get_if<int>(&value)) return *whole;
  }
  return otherwise;
}

}  // namespace umbra::plot
