#include "analysis/plots/FourierPlots.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"
#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Text.h"
#include "filters/techniques/csm/Csm.h"
#include "filters/techniques/csm/CsmSum.h"

namespace umbra {
namespace {

constexpr std::string_view fourierColour = "#8c6d31";
constexpr std::string_view scaleColour = "#7b4fa3";

// The largest value of the series and where it is, on the lit side of the step; it is symmetric
// about t = ½.
std::pair<double, double> highestOf(const csm::FourierSeries& series) {
  const int steps = 256 * series.terms();
  std::pair<double, double> highest{0.0, 0.0};
  for (int i = 0; i <= steps; ++i) {
    const double t = 0.5 * i / steps;
    if (series(t) > highest.second) highest = {t, series(t)};
  }
  return highest;
}

// The parameters of the probe's technique csm, or the defaults where the probe has none.
csm::CsmParameters parametersOf(const Probe& probe) {
  const TechniqueResult* result = resultOf(probe, "csm");
  const auto* technique = result ? dynamic_cast<const csm::Csm*>(result->technique.get()) : nullptr;
  return technique ? technique->values : csm::CsmParameters();
}

// The visibility of `region` by csm in offset mode, for receivers at `depths`.
std::vector<double> visibilitiesOf(const Region& region, int terms, double attenuation,
                                   const std::vector<double>& depths) {
  csm::Csm technique;
  technique.values.terms = terms;
  technique.values.attenuation = attenuation;
  const csm::FourierSeries series = technique.series();
  const std::vector<double> channels = prefilteredRegion(region, technique, StorageFormat::Double);
  std::vector<double> values;
  for (double depth : depths)
    values.push_back(csm::sumOfTerms(technique, series, channels, depth, Unrecorded()));
  return values;
}

}  // namespace

Plot fourierStepPlot(int terms, double attenuation) {
  const PlotRange range{-0.5, 0.5};
  const double shown = attenuation > 0.0 ? attenuation : 1.0;
  const csm::FourierSeries plain(terms, 0.0), damped(terms, shown);
  const csm::FourierSeries& used = attenuation > 0.0 ? damped : plain;
  Plot plot{.name = "fourier-step",
            .title = "The shadow test as a Fourier series · M = " + std::to_string(terms) +
                     ", α = " + shortNumber(attenuation),
            .xLabel = "occluder's depth less receiver's, z − d",
            .yLabel = "visibility",
            .xRange = range,
            .yRange = PlotRange{-0.25, 1.35}};
  plot.series.push_back({"exact step",
                         std::string(referenceColour),
                         SeriesStyle::Steps,
                         {range.low, 0.0, range.high},
                         {0.0, 1.0, 1.0},
                         plot::normal});
  const auto add = [&](std::string name, std::string_view colour, double width, auto function) {
    plot.series.push_back(plot::sampled(std::move(name), colour, range, function));
    plot.series.back().lineWidth = width;
  };
  add("series, α = 0", plot::tint(fourierColour, attenuation > 0.0 ? 0.55 : 1.0), plot::thin,
      plain);
  add("attenuated, α = " + shortNumber(shown),
      plot::tint(fourierColour, attenuation > 0.0 ? 1.0 : 0.55), plot::thin, damped);
  plot.series.back().dashed = attenuation <= 0.0;
  add("offset mode, o = " + plot::fixed3(used.offset()), depthColour, plot::thick,
      [&](double t) { return std::clamp(used(t + used.offset()), 0.0, 1.0); });
  add("scale mode, 2f", scaleColour, plot::normal,
      [&](double t) { return std::clamp(2.0 * used(t), 0.0, 1.0); });
  const auto [at, highest] = highestOf(used);
  plot::addError(plot, at, 1.0, highest, "ringing " + plot::signed3(highest - 1.0));
  return plot;
}

Plot fourierStepPlot(const Probe& probe) {
  const csm::CsmParameters parameters = parametersOf(probe);
  return fourierStepPlot(parameters.terms, parameters.attenuation);
}

Plot fourierTermsPlot(const Probe& probe) {
  const csm::CsmParameters used = parametersOf(probe);
  const double attenuation = used.attenuation;
  const PlotRange range = plot::rangeAround(probe);
  Plot plot{
      .name = "fourier-terms",
      .title = "Visibility of the region from M Fourier terms · α = " + shortNumber(attenuation),
      .xLabel = plot::depthLabel(),
      .yLabel = "visibility",
      .xRange = range,
      .yRange = PlotRange{0.0, 1.02}};
  PlotSeries exact = plot::sampled("exact", referenceColour, range,
                                   [&](double z) { return referenceVisibility(probe.region, z); });
  exact.lineWidth = plot::normal;
  const std::vector<double> depths = exact.x;
  plot.series.push_back(std::move(exact));
  for (int terms : {1, 2, 4, 8, 16}) {
    PlotSeries series{"M = " + std::to_string(terms),
                      plot::tint(fourierColour, 0.25 + 0.15 * std::log2(2.0 * terms)),
                      SeriesStyle::Line, depths,
                      visibilitiesOf(probe.region, terms, attenuation, depths)};
    series.lineWidth = terms == used.terms ? plot::thick : plot::thin;
    plot.series.push_back(std::move(series));
  }
  plot.markers.push_back(plot::receiverMarker(probe.receiver));
  return plot;
}

}  // namespace umbra
