#include "analysis/plots/ProbePlots.h"

#include <algorithm>
#include <cmath>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/PowerPlots.h"
#include "filters/core/support/Text.h"

namespace umbra {

using namespace plot;

namespace {

constexpr std::string_view meanColour = "#52606d";
constexpr std::string_view extremeColour = "#9aa5b1";

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string errorLabel(double error) {
  return (error > 0.0 ? "bleeding " : "over-darkening ") + signed3(error);
}

PlotRange unitRange() {
  return {0.0, 1.0};
}

// By Lauritzen 2008, eq. 3.3, at least 1 − p_max of the region lies in front of z.
double chebyshevCdf(const RegionStatistics& s, double z) {
  if (z <= s.mean) return 0.0;
  const double distance = z - s.mean;
  return distance * distance / (s.variance + distance * distance);
}

}  // namespace

Plot histogramPlot(const Probe& probe, int bins) {
  const RegionStatistics& s = probe.statistics;
  Histogram histogram = histogramOf(probe.region, bins);
  Plot plot{.name = "histogram",
            .title = "Depths in the region · " + counted(probe.region.texels.size(), "texel")};
  if (s.min < s.max) {
    plot.title += " · " + counted(histogram.weights.size(), "bin");
  } else {
    plot.title += " · one depth, z = " + fixed3(s.min);
    // A bin of width 0 could not be seen; this one is as wide as the plot's narrowest bin.
    histogram.edges = {s.min - 0.005, s.max + 0.005};
  }
  plot.xLabel = depthLabel();
  plot.yLabel = "share of weight";
  plot.xRange = unitRange();
  const double highest = *std::max_element(histogram.weights.begin(), histogram.weights.end());
  plot.yRange = PlotRange{0.0, 1.05 * highest};
  plot.series.push_back({"depths", std::string(depthColour), SeriesStyle::Bars, histogram.edges,
                         histogram.weights, thin});

  const auto mark = [&](double position, const std::string& label, std::string_view colour) {
    plot.markers.push_back({MarkerAxis::Vertical, position, label, std::string(colour), true});
  };
  if (s.min < s.max) {
    mark(s.min, "min", extremeColour);
    mark(s.mean, "mean μ", meanColour);
    // Lauritzen expects the second occluder here (§4.1.3).
    mark(s.mean + std::sqrt(s.variance), "μ + σ", extremeColour);
    mark(s.max, "max", extremeColour);
  }
  mark(probe.receiver, "receiver", probeColour);
  plot.markers.back().draggable = true;
  return plot;
}

Plot curvesPlot(const Probe& probe, std::string_view selected, int samples) {
  const Curves curves = curvesOf(probe, samples);
  Plot plot{.name = "curves",
            .title = "Visibility of the region, every technique",
            .xLabel = depthLabel(),
            .yLabel = "visibility v(z)",
            .xRange = unitRange(),
            .yRange = PlotRange{0.0, 1.02}};
  plot.series.push_back({"exact", std::string(referenceColour), SeriesStyle::Line, curves.depth,
                         curves.reference, normal});
  std::optional<PlotSeries> emphasised;
  for (std::size_t i = 0; i < probe.techniques.size(); ++i) {
    const TechniqueResult& result = probe.techniques[i];
    const TechniqueInfo& info = result.technique->info();
    PlotSeries series{legendName(info), std::string(info.colour), SeriesStyle::Line,
                      curves.depth,     curves.techniques[i],     thin};
    if (info.id != selected) {
      plot.series.push_back(std::move(series));
      continue;
    }
    series.lineWidth = thick;
    emphasised = std::move(series);
    addError(plot, probe.receiver, probe.reference, result.visibility, errorLabel(result.error));
  }
  // This series is last, so that it lies on top of the others.
  if (emphasised) plot.series.push_back(std::move(*emphasised));
  plot.markers.push_back(receiverMarker(probe.receiver));
  return plot;
}

Plot cdfPlot(const Probe& probe) {
  const RegionStatistics& s = probe.statistics;
  const PlotRange range = rangeAround(probe);
  Plot plot{.name = "cdf",
            .title = "Share of the region in front of a depth",
            .xLabel = depthLabel(),
            .yLabel = "F(z)",
            .xRange = range,
            .yRange = PlotRange{0.0, 1.02}};

  const EmpiricalCdf cdf = empiricalCdfOf(probe.region);
  PlotSeries exact{"exact", std::string(referenceColour), SeriesStyle::Steps};
  exact.lineWidth = normal;
  exact.x.push_back(range.low);
  exact.y.push_back(0.0);
  exact.x.insert(exact.x.end(), cdf.depth.begin(), cdf.depth.end());
  exact.y.insert(exact.y.end(), cdf.cumulative.begin(), cdf.cumulative.end());
  exact.x.push_back(range.high);
  exact.y.push_back(1.0);
  plot.series.push_back(std::move(exact));

  const auto addPower = [&](const std::string& name, std::string_view colour,
                            const RegionStatistics& fit) {
    const std::string beta = std::isinf(fit.beta) ? "∞" : shortNumber(fit.beta);
    plot.series.push_back(
        sampled(name + ", β = " + beta, colour, range, [&](double z) { return powerCdf(fit, z); }));
  };
  const RegionStatistics inUse = powerFitOf(probe);
  if (differs(inUse, s)) addPower("this region's own fit", tint(powerColour, 0.5), s);
  addPower("power CDF t^β", powerColour, inUse);
  const std::string chebyshev = "Chebyshev 1 − p_max";
  plot.series.push_back(
      sampled(chebyshev, chebyshevColour, range, [&](double z) { return chebyshevCdf(s, z); }));

  // Blocking depths lie strictly in front of z_r: this is F just before z_r.
  const double blocked = 1.0 - probe.reference;
  const double bound = chebyshevCdf(s, probe.receiver);
  addError(plot, probe.receiver, blocked, bound, "error " + signed3(blocked - bound));
  plot.markers.push_back(receiverMarker(probe.receiver));
  return plot;
}

}  // namespace umbra
