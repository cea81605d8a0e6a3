#include "analysis/plots/PlanesForm.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/errors/BleedReduction.h"
#include "analysis/plots/ChebyshevPlots.h"
#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"

namespace umbra {
namespace {

constexpr std::string_view predictedColour = "#7b4fa3";
constexpr std::string_view measuredColour = "#2563c9";

// VSM without light-bleeding reduction, which would cut off the tail of the bound that is
// predicted.
std::shared_ptr<const Technique> unreduced(const TechniqueResult& vsm) {
  return withBleedReduction(*vsm.technique, 0.0);
}

double minVarianceOf(const Technique& technique) {
  return plot::parameterOf(technique, "min-variance", 0.0);
}

std::string bothNumbers(const PlanesPrediction& prediction) {
  return "predicted " + plot::fixed3(prediction.predicted) + ", measured " +
         plot::fixed3(prediction.measured);
}

// Gives the nearest plane the share `share`, and the other planes the rest in their proportions.
PlaneShares withNearestShare(const PlaneShares& planes, double share) {
  PlaneShares changed = planes;
  double others = 0.0;
  for (std::size_t i = 1; i < planes.shares.size(); ++i) others += planes.shares[i];
  changed.shares[0] = share;
  for (std::size_t i = 1; i < planes.shares.size(); ++i)
    changed.shares[i] = others > 0.0 ? (1.0 - share) * planes.shares[i] / others
                                     : (1.0 - share) / double(planes.shares.size() - 1);
  return changed;
}

}  // namespace

std::optional<PlaneShares> planeSharesOf(const Probe& probe, std::span<const double> depths) {
  PlaneShares planes{{depths.begin(), depths.end()}, std::vector<double>(depths.size(), 0.0)};
  for (const RegionTexel& texel : probe.region.texels) {
    const auto on = std::find_if(depths.begin(), depths.end(), [&](double depth) {
      return std::abs(texel.depth - depth) <= planeTolerance;
    });
    if (on == depths.end()) return std::nullopt;
    planes.shares[on - depths.begin()] += texel.weight;
  }
  return planes;
}

double predictedVisibility(const PlaneShares& planes, double receiver, double minVariance) {
  double mean = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < planes.depths.size(); ++i)
    mean += planes.shares[i] * planes.depths[i];
  for (std::size_t i = 0; i < planes.depths.size(); ++i)
    variance += planes.shares[i] * (planes.depths[i] - mean) * (planes.depths[i] - mean);
  return chebyshevBound(mean, std::max(variance, minVariance), receiver);
}

std::optional<PlanesPrediction> predictPlanes(const Probe& probe, std::span<const double> depths) {
  const TechniqueResult* vsm = resultOf(probe, "vsm");
  const std::optional<PlaneShares> planes = planeSharesOf(probe, depths);
  if (!vsm || !planes || depths.empty()) return std::nullopt;
  PlanesPrediction prediction{.planes = *planes};
  const std::shared_ptr<const Technique> technique = unreduced(*vsm);
  prediction.predicted = predictedVisibility(*planes, probe.receiver, minVarianceOf(*technique));
  prediction.ideal = predictedVisibility(*planes, depths.back());
  prediction.measured = visibilityOf(*technique, probe, *vsm, probe.receiver);
  return prediction;
}

Plot planesPlot(const Probe& probe, const PlanesPrediction& prediction) {
  const PlotRange range = plot::rangeAround(probe);
  Plot plot{.name = "planes",
            .title = "Closed form and measurement · " + bothNumbers(prediction),
            .xLabel = plot::depthLabel(),
            .yLabel = "visibility v(z)",
            .xRange = range,
            .yRange = PlotRange{0.0, 1.02}};
  const TechniqueResult& vsm = *resultOf(probe, "vsm");
  const std::shared_ptr<const Technique> technique = unreduced(vsm);
  plot.series.push_back(plot::sampled("exact", referenceColour, range, [&](double z) {
    return referenceVisibility(probe.region, z);
  }));
  plot.series.push_back(plot::sampled("VSM, measured", measuredColour, range, [&](double z) {
    return visibilityOf(*technique, probe, vsm, z);
  }));
  plot.series.back().lineWidth = plot::thick;
  const double least = minVarianceOf(*technique);
  plot.series.push_back(plot::sampled("closed form", predictedColour, range, [&](double z) {
    return predictedVisibility(prediction.planes, z, least);
  }));
  plot.series.back().dashed = true;
  constexpr std::string_view names = "ABC";
  for (std::size_t i = 0; i < prediction.planes.depths.size() && i < names.size(); ++i)
    plot.markers.push_back({MarkerAxis::Vertical, prediction.planes.depths[i],
                            std::string(1, names[i]) + ", " +
                                plot::fixed3(prediction.planes.shares[i]) + " of the region",
                            "#9aa5b1", true});
  plot.markers.push_back(plot::receiverMarker(probe.receiver));
  plot::addError(plot, probe.receiver, probe.reference, prediction.measured,
                 "error " + plot::signed3(prediction.measured - probe.reference));
  return plot;
}

Plot coveragePlot(const Probe& probe, const PlanesPrediction& prediction) {
  const double share = prediction.planes.shares.front();
  Plot plot{.name = "coverage",
            .title = "Visibility over the share that A covers · " + bothNumbers(prediction),
            .xLabel = "share of the region that A covers",
            .yLabel = "visibility",
            .xRange = PlotRange{0.0, 1.0},
            .yRange = PlotRange{0.0, 1.02}};
  const double least = minVarianceOf(*resultOf(probe, "vsm")->technique);
  plot.series.push_back(plot::sampled("closed form", predictedColour, {0.0, 1.0}, [&](double s) {
    return predictedVisibility(withNearestShare(prediction.planes, s), probe.receiver, least);
  }));
  plot.series.push_back({"measured",
                         std::string(measuredColour),
                         SeriesStyle::Points,
                         {share},
                         {prediction.measured}});
  plot.markers.push_back({MarkerAxis::Vertical, share, "this region, " + plot::fixed3(share),
                          std::string(probeColour), true});
  return plot;
}

}  // namespace umbra
