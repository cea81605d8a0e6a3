#include "analysis/plots/ChebyshevPlots.h"

#include <algorithm>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {}  // namespace

double chebyshevBound(double mean, double variance, double receiver) {
  if (receiver <= mean) return 1.0;
  const double distance = receiver - mean;
  return variance / (variance + distance * distance);
}

// This is eq. 3.3 at C, with μ = B − sΔx and σ² = s(1 − s)Δx².
double bleedingOfTwoOccluders(double dx, double dy, double shareOfA) {
  const double variance = shareOfA * (1.0 - shareOfA) * dx * dx;
  const double distance = dy + shareOfA * dx;
  return variance / (variance + distance * distance);
}

std::optional<TwoOccluders> twoOccludersOf(const Probe& probe) {
  TwoOccluders planes{1.0, 0.0, probe.receiver, 0.5};
  double weight = 0.0, sum = 0.0;
  for (const RegionTexel& texel : probe.region.texels) {
    if (texel.depth >= probe.receiver) continue;
    planes.a = std::min(planes.a, texel.depth);
    planes.b = std::max(planes.b, texel.depth);
    weight += texel.weight;
    sum += texel.weight * texel.depth;
  }
  if (weight == 0.0) return std::nullopt;
  if (planes.a < planes.b)
    planes.shareOfA = std::clamp((planes.b - sum / weight) / (planes.b - planes.a), 0.0, 1.0);
  return planes;
}

Plot varianceFamilyPlot(const Probe& probe) {
  const RegionStatistics& s = probe.statistics;
  const PlotRange range = plot::rangeAround(probe);
  Plot plot{.name = "chebyshev",
            .title = "The bound as the region's variance grows",
            .xLabel = plot::depthLabel(),
            .yLabel = "visibility p_max",
            .xRange = range,
            .yRange = PlotRange{0.0, 1.02}};
  struct Member {
    double factor;
    const char* name;
    double tint;
  };
  for (const auto& [factor, name, tint] : {Member{0.5, "½ σ²", 0.4}, Member{1.0, "σ²", 1.0},
                                           Member{2.0, "2 σ²", 0.75}, Member{4.0, "4 σ²", 0.55}}) {
    PlotSeries series =
        plot::sampled(name, plot::tint(chebyshevColour, tint), range,
                      [&](double z) { return chebyshevBound(s.mean, factor * s.variance, z); });
    series.lineWidth = factor == 1.0 ? plot::thick : plot::thin;
    if (factor == 1.0) series.name += " = " + shortNumber(s.variance);
    plot.series.push_back(std::move(series));
  }
  plot.markers.push_back(
      {MarkerAxis::Vertical, s.mean, "mean μ = " + plot::fixed3(s.mean), "#52606d", true});
  plot.markers.push_back(plot::receiverMarker(probe.receiver));
  const double bound = chebyshevBound(s.mean, s.variance, probe.receiver);
  plot::addError(plot, probe.receiver, probe.reference, bound,
                 "error " + plot::signed3(bound - probe.reference));
  return plot;
}

Plot occluderDistancePlot(const Probe& probe) {
  Plot plot{.name = "distance",
            .title = "Light bleeding as the upper occluder A moves away from B",
            .xLabel = "Δx = B − A (normalised depth)",
            .yLabel = "visibility of C, which is hidden",
            .yRange = PlotRange{0.0, 1.02}};
  const std::optional<TwoOccluders> planes = twoOccludersOf(probe);
  if (!planes) {
    plot.title = "Nothing lies in front of the receiver";
    plot.xRange = PlotRange{0.0, 1.0};
    return plot;
  }
  const double dx = planes->b - planes->a, dy = planes->c - planes->b, share = planes->shareOfA;
  const PlotRange range{0.0, std::max({2.0 * dx, 2.0 * dy, 0.02})};
  plot.xRange = range;
  for (const auto& [factor, tint] : {std::pair{0.5, 0.55}, {1.0, 1.0}, {2.0, 0.7}}) {
    const double gap = factor * dy;
    PlotSeries series =
        plot::sampled("Δy = " + plot::fixed3(gap), plot::tint(chebyshevColour, tint), range,
                      [&](double x) { return bleedingOfTwoOccluders(x, gap, share); });
    series.lineWidth = factor == 1.0 ? plot::thick : plot::thin;
    plot.series.push_back(std::move(series));
  }
  plot.title += " · A covers " + shortNumber(100.0 * share) + " %";
  plot.markers.push_back({MarkerAxis::Vertical, dx, "this region, Δx = " + plot::fixed3(dx),
                          std::string(probeColour), true});
  const double bleeding = bleedingOfTwoOccluders(dx, dy, share);
  plot::addError(plot, dx, 0.0, bleeding, "bleeding " + plot::signed3(bleeding));
  return plot;
}

}  // namespace umbra
