#include "analysis/plots/ChebyshevPlots.h"

#include <algorithm>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"
#include "filters/core/support/Text.h"

namespace umbra {

double chebyshevBound(double mean, double variance, double receiver) {
  if (receiver <= mean) return 1.0;
  const double distance = receiver - mean;
  return variance / (variance + distance * distance);
}

std::optional<Occluders> Occluders::of(const Probe& probe) {
  double nearest = probe.receiver, farthest = -1.0;
  for (const RegionTexel& texel : probe.region.texels) {
    if (texel.depth >= probe.receiver) continue;
    nearest = std::min(nearest, texel.depth);
    farthest = std::max(farthest, texel.depth);
  }
  if (farthest <= nearest) return std::nullopt;
  Occluders occluders;
  occluders.spread_ = farthest - nearest;
  occluders.gap_ = probe.receiver - farthest;
  for (const RegionTexel& texel : probe.region.texels) {
    const bool blocks = texel.depth < probe.receiver;
    const double distance = blocks ? farthest - texel.depth : texel.depth - probe.receiver;
    const double sum = texel.weight * distance, squares = sum * distance;
    occluders.weight_ += blocks ? texel.weight : 0.0;
    (blocks ? occluders.apart_ : occluders.behind_) += sum;
    (blocks ? occluders.apartSquared_ : occluders.behindSquared_) += squares;
  }
  return occluders;
}

// Moments about the receiver, so that no digits are lost: occluders are at −dy − scale·(B − d).
double Occluders::boundAt(double dx, double dy) const {
  const double scale = dx / spread_;
  const double mean = -dy * weight_ - scale * apart_ + behind_;
  const double square = dy * dy * weight_ + 2.0 * dy * scale * apart_ +
                        scale * scale * apartSquared_ + behindSquared_;
  return chebyshevBound(mean, std::max(0.0, square - mean * mean), 0.0);
}

Plot varianceFamilyPlot(const Probe& probe) {
  const RegionStatistics& s = probe.statistics;
  const PlotRange range = plot::rangeAround(probe);
  Plot plot{.name = "chebyshev",
            .title = "VSM's bound as the region's variance grows",
            .xLabel = plot::depthLabel(),
            .yLabel = "visibility p_max",
            .xRange = range,
            .yRange = PlotRange{0.0, 1.02}};
  struct Member {
    double factor;
    const char* name;
    double tint;
  };
  for (const Member& member : {Member{0.5, "½ σ²", 0.4}, Member{1.0, "σ²", 1.0},
                               Member{2.0, "2 σ²", 0.75}, Member{4.0, "4 σ²", 0.55}}) {
    PlotSeries series = plot::sampled(
        member.name, plot::tint(chebyshevColour, member.tint), range,
        [&](double z) { return chebyshevBound(s.mean, member.factor * s.variance, z); });
    series.lineWidth = member.factor == 1.0 ? plot::thick : plot::thin;
    if (member.factor == 1.0) series.name += " = " + shortNumber(s.variance);
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

std::optional<Plot> occluderDistancePlot(const Probe& probe) {
  const std::optional<Occluders> occluders = Occluders::of(probe);
  if (!occluders) return std::nullopt;
  const double dx = occluders->spread(), dy = occluders->gap();
  const PlotRange range{0.0, std::max({2.0 * dx, 2.0 * dy, 0.02})};
  Plot plot{.name = "distance",
            .title = "VSM's bound as the occluders move apart",
            .xLabel = "Δx, from the farthest occluder to the nearest (normalised depth)",
            .yLabel = "visibility p_max",
            .xRange = range,
            .yRange = PlotRange{0.0, 1.02}};
  for (const auto& [factor, tint] : {std::pair{0.5, 0.55}, {1.0, 1.0}, {2.0, 0.7}}) {
    const double gap = factor * dy;
    PlotSeries series =
        plot::sampled("Δy = " + plot::fixed3(gap), plot::tint(chebyshevColour, tint), range,
                      [&](double x) { return occluders->boundAt(x, gap); });
    series.lineWidth = factor == 1.0 ? plot::thick : plot::thin;
    plot.series.push_back(std::move(series));
  }
  plot.markers.push_back({MarkerAxis::Vertical, dx, "this region, Δx = " + plot::fixed3(dx),
                          std::string(probeColour), true});
  const double bound = occluders->boundAt(dx, dy);
  plot::addError(plot, dx, probe.reference, bound,
                 "error " + plot::signed3(bound - probe.reference));
  return plot;
}

}  // namespace umbra
