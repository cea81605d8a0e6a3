#include "analysis/plots/Precision.h"

#include <algorithm>
#include <cmath>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"

namespace umbra {
namespace {

constexpr std::pair<StorageFormat, std::string_view> formats[] = {
    {StorageFormat::Unorm8, "#b45309"},
    {StorageFormat::Unorm16, "#7b4fa3"},
    {StorageFormat::Half, "#2563c9"},
    {StorageFormat::Float, "#0f8b8d"}};

TechniqueResult readIn(ProbeRequest request, StorageFormat format,
                       const std::shared_ptr<const Technique>& technique) {
  request.format = format;
  request.techniques = {technique};
  return takeProbe(request).techniques.front();
}

FormatPrecision measured(const ProbeRequest& request, const Technique& technique,
                         StorageFormat format) {
  FormatPrecision result{.format = format, .refusal = technique.refusal(format)};
  if (!result.refusal.empty()) return result;
  const std::shared_ptr<Technique> limited = technique.clone();
  result.limits = limited->limitTo(format);
  const TechniqueResult exact = readIn(request, StorageFormat::Double, limited);
  const TechniqueResult rounded = readIn(request, format, limited);
  result.channels = rounded.channels;
  for (std::size_t i = 0; i < exact.channels.size(); ++i)
    result.errors.push_back(std::abs(rounded.channels[i] - exact.channels[i]));
  result.visibility = rounded.visibility;
  result.visibilityError = std::abs(rounded.visibility - exact.visibility);
  return result;
}

}  // namespace

TechniquePrecision precisionOf(const ProbeRequest& request,
                               const std::shared_ptr<const Technique>& technique) {
  TechniquePrecision precision{technique, {}};
  for (const auto& [format, colour] : formats)
    precision.formats.push_back(measured(request, *technique, format));
  return precision;
}

Plot precisionPlot(const TechniquePrecision& precision) {
  const std::vector<Channel> layout = precision.technique->channels();
  Plot plot{.name = "precision",
            .title = "Stored against double · " + plot::legendName(precision.technique->info()),
            .xLabel = "channel",
            .yLabel = "log₁₀ |stored − double|",
            .xRange = PlotRange{0.5, double(layout.size()) + 1.5},
            .wholeX = true};
  for (std::size_t f = 0; f < precision.formats.size(); ++f) {
    const FormatPrecision& format = precision.formats[f];
    if (!format.refusal.empty()) continue;
    PlotSeries series{std::string(nameOf(format.format)), std::string(formats[f].second),
                      SeriesStyle::Points};
    const auto add = [&](std::size_t place, double error) {
      if (error == 0.0) return;
      series.x.push_back(double(place));
      series.y.push_back(std::log10(error));
    };
    for (std::size_t c = 0; c < format.errors.size(); ++c) add(c + 1, format.errors[c]);
    add(format.errors.size() + 1, format.visibilityError);
    plot.series.push_back(std::move(series));
  }
  // More names than these would lie over one another.
  const std::size_t step = std::max<std::size_t>(1, layout.size() / 8);
  for (std::size_t c = 0; c < layout.size(); c += step)
    plot.markers.push_back({MarkerAxis::Vertical, double(c + 1), layout[c].name, "#c3cad2", true});
  plot.markers.push_back({MarkerAxis::Vertical, double(layout.size() + 1), "visibility",
                          std::string(referenceColour), true});
  return plot;
}

}  // namespace umbra
