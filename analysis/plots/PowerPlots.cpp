#include "analysis/plots/PowerPlots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"
#include "filters/core/support/Text.h"
#include "filters/core/technique/VisibleError.h"

namespace umbra {
namespace {

std::string betaText(double beta) {
  return std::isinf(beta) ? "∞" : shortNumber(beta);
}

// The region's distribution over t. For a region of one depth it is a step at the far end.
PlotSeries empirical(const Probe& probe) {
  const RegionStatistics& s = probe.statistics;
  const EmpiricalCdf cdf = empiricalCdfOf(probe.region);
  PlotSeries series{"this region", std::string(referenceColour), SeriesStyle::Steps, {0.0}, {0.0}};
  for (std::size_t i = 0; i < cdf.depth.size(); ++i) {
    series.x.push_back(s.max > s.min ? (cdf.depth[i] - s.min) / (s.max - s.min) : 1.0);
    series.y.push_back(cdf.cumulative[i]);
  }
  series.lineWidth = plot::normal;
  return series;
}

// The technique's channel of that name, as the frame reads it.
double channelOf(const TechniqueResult& result, std::string_view name) {
  const std::vector<Channel> layout = result.technique->channels();
  const auto found = std::find_if(layout.begin(), layout.end(),
                                  [&](const Channel& channel) { return channel.name == name; });
  return result.channels[std::size_t(found - layout.begin())];
}

}  // namespace

RegionStatistics powerFitOf(const Probe& probe) {
  RegionStatistics fit = probe.statistics;
  const TechniqueResult* used = resultOf(probe, "power-cdf");
  if (!used) return fit;
  fit.min = channelOf(*used, "min");
  fit.max = std::max(fit.min, channelOf(*used, "max"));
  fit.mean = std::clamp(channelOf(*used, "mean"), fit.min, fit.max);
  fit.beta = fit.max > fit.mean ? (fit.mean - fit.min) / (fit.max - fit.mean)
                                : std::numeric_limits<double>::infinity();
  return fit;
}

bool differs(const RegionStatistics& fit, const RegionStatistics& region) {
  constexpr int samples = 200;
  const double low = std::min(fit.min, region.min), high = std::max(fit.max, region.max);
  for (int i = 0; i <= samples; ++i) {
    const double z = std::lerp(low, high, double(i) / samples);
    // At their ends both jump, which a rounded end puts on one side or the other.
    if (z == low || z == high) continue;
    if (isVisibleError(powerCdf(fit, z) - powerCdf(region, z))) return true;
  }
  return false;
}

double powerCdf(const RegionStatistics& s, double z) {
  if (z >= s.max) return 1.0;
  if (z <= s.min || std::isinf(s.beta)) return 0.0;
  return std::pow((z - s.min) / (s.max - s.min), s.beta);
}

Plot powerFamilyPlot(const Probe& probe) {
  const RegionStatistics& s = probe.statistics;
  Plot plot{.name = "power-family",
            .title = "Power functions t^β and the region's distribution",
            .xLabel = "t = (z − min) / (max − min)",
            .yLabel = "F(t)",
            .xRange = PlotRange{0.0, 1.0},
            .yRange = PlotRange{0.0, 1.02}};
  for (double beta : {0.5, 1.0, 2.0, 5.0}) {
    plot.series.push_back(
        plot::sampled("β = " + shortNumber(beta),
                      plot::tint(powerColour, 0.3 + 0.2 * std::log2(2.0 * beta) / 1.5), {0.0, 1.0},
                      [beta](double t) { return std::pow(t, beta); }));
    plot.series.back().lineWidth = plot::thin;
  }
  plot.series.push_back(empirical(probe));
  const RegionStatistics fit = powerFitOf(probe);
  const auto addFit = [&](const std::string& name, const RegionStatistics& of) {
    plot.series.push_back(
        plot::sampled(name + ", β = " + betaText(of.beta), powerColour, {0.0, 1.0},
                      [&](double t) { return powerCdf(of, std::lerp(s.min, s.max, t)); }));
  };
  const bool two = differs(fit, s);
  if (two) addFit("this region's own fit", s);
  addFit(two ? "fit in use" : "fitted", fit);
  plot.series.back().lineWidth = plot::thick;
  const double t = s.max > s.min ? (probe.receiver - s.min) / (s.max - s.min) : 1.0;
  if (t >= 0.0 && t <= 1.0)
    plot.markers.push_back({MarkerAxis::Vertical, t, "receiver t = " + plot::fixed3(t),
                            std::string(probeColour), true});
  return plot;
}

Plot residualPlot(const Probe& probe) {
  const RegionStatistics s = powerFitOf(probe);
  const EmpiricalCdf cdf = empiricalCdfOf(probe.region);
  const PlotRange range = plot::rangeAround(probe);
  Plot plot{.name = "residual",
            .title = "Power CDF in use less the exact one · β = " + betaText(s.beta),
            .xLabel = plot::depthLabel(),
            .yLabel = "t^β − F(z)",
            .xRange = range};
  PlotSeries series{"fitted − exact", std::string(powerColour)};
  double worst = 0.0, worstAt = s.min;
  const auto add = [&](double z, double fitted, double exact) {
    const double residual = fitted - exact;
    series.x.push_back(z);
    series.y.push_back(residual);
    if (std::abs(residual) <= std::abs(worst)) return;
    worst = residual;
    worstAt = z;
  };
  add(range.low, powerCdf(s, range.low), 0.0);
  double before = 0.0;
  std::size_t next = 0;
  for (int i = 0; i < plot::curveSamples; ++i) {
    const double sample = std::lerp(s.min, s.max, double(i) / (plot::curveSamples - 1));
    for (; next < cdf.depth.size() && cdf.depth[next] <= sample; ++next) {
      const double z = cdf.depth[next];
      // Without a finite β the fit jumps where the region's distribution does.
      add(z, std::isinf(s.beta) ? 0.0 : powerCdf(s, z), before);
      before = cdf.cumulative[next];
      add(z, powerCdf(s, z), before);
    }
    add(sample, powerCdf(s, sample), before);
  }
  add(range.high, powerCdf(s, range.high), 1.0);
  plot.series.push_back(std::move(series));
  const double reach = std::max(1.15 * std::abs(worst), 0.05);
  plot.yRange = PlotRange{-reach, reach};
  plot.markers.push_back({MarkerAxis::Horizontal, 0.0, "", "#9aa5b1", true});
  plot.markers.push_back(plot::receiverMarker(probe.receiver));
  plot::addError(plot, worstAt, 0.0, worst, "largest " + plot::signed3(worst));
  return plot;
}

}  // namespace umbra
