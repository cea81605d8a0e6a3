#include "analysis/plots/FourierPlots.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
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

struct Swing {
  double at, exact, value;
};

// The largest swing that is left after the clamp to [0,1], beyond the step itself: in shadow from
// where the function has come down to 0, in the light from where it has come up to 1. None where it
// never gets there. Beyond a quarter of the period the next step begins.
std::optional<Swing> ringingOf(const std::function<double(double)>& mode, int terms) {
  std::optional<Swing> largest;
  const int steps = 256 * terms;
  for (const double exact : {0.0, 1.0}) {
    bool settled = false;
    for (int i = 0; i <= steps; ++i) {
      const double t = (exact - 0.5) * 0.5 * i / steps, value = mode(t);
      settled = settled || value == exact;
      const double swing = std::abs(value - exact);
      if (settled && swing > (largest ? std::abs(largest->value - largest->exact) : 0.0))
        largest = {t, exact, value};
    }
  }
  return largest;
}

// The parameters of the probe's technique csm, or the defaults where the probe has none.
csm::CsmParameters parametersOf(const Probe& probe) {
  const TechniqueResult* result = resultOf(probe, "csm");
  const auto* technique = result ? dynamic_cast<const csm::Csm*>(result->technique.get()) : nullptr;
  return technique ? technique->values : csm::CsmParameters();
}

// The visibility of `region` by csm with these parameters, for receivers at `depths`.
std::vector<double> visibilitiesOf(const Region& region, const csm::CsmParameters& parameters,
                                   const std::vector<double>& depths) {
  csm::Csm technique;
  technique.values = parameters;
  const csm::FourierSeries series = technique.series();
  const std::vector<double> channels = prefilteredRegion(region, technique, StorageFormat::Double);
  std::vector<double> values;
  for (double depth : depths)
    values.push_back(csm::sumOfTerms(technique, series, channels, depth, Unrecorded()));
  return values;
}

}  // namespace

Plot fourierStepPlot(int terms, double attenuation, csm::Mode mode) {
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
  const auto add = [&](const std::string& name, std::string_view colour, double width,
                       const auto& function) {
    plot.series.push_back(plot::sampled(name, colour, range, function));
    plot.series.back().lineWidth = width;
  };
  add("series, α = 0", plot::tint(fourierColour, attenuation > 0.0 ? 0.55 : 1.0), plot::thin,
      plain);
  add("attenuated, α = " + shortNumber(shown),
      plot::tint(fourierColour, attenuation > 0.0 ? 1.0 : 0.55), plot::thin, damped);
  plot.series.back().dashed = attenuation <= 0.0;
  const auto offset = [&](double t) { return std::clamp(used(t + used.offset()), 0.0, 1.0); };
  const auto scaled = [&](double t) { return std::clamp(2.0 * used(t), 0.0, 1.0); };
  const bool offsets = mode == csm::Mode::Offset;
  add("offset mode, o = " + plot::fixed3(used.offset()), depthColour,
      offsets ? plot::thick : plot::normal, offset);
  add("scale mode, 2f", scaleColour, offsets ? plot::normal : plot::thick, scaled);
  const auto inUse = offsets ? std::function<double(double)>(offset) : scaled;
  if (const auto left = ringingOf(inUse, terms))
    plot::addError(plot, left->at, left->exact, left->value,
                   "ringing " + plot::signed3(left->value - left->exact));
  return plot;
}

Plot fourierStepPlot(const Probe& probe) {
  const csm::CsmParameters parameters = parametersOf(probe);
  return fourierStepPlot(parameters.terms, parameters.attenuation, parameters.mode);
}

Plot fourierTermsPlot(const Probe& probe) {
  const csm::CsmParameters used = parametersOf(probe);
  const double attenuation = used.attenuation;
  const PlotRange range = plot::rangeAround(probe);
  Plot plot{
      .name = "fourier-terms",
      .title = "Visibility of the region from M Fourier terms · α = " + shortNumber(attenuation) +
               ", " + std::string(csm::modeNames[std::size_t(used.mode)]) + " mode",
      .xLabel = plot::depthLabel(),
      .yLabel = "visibility",
      .xRange = range,
      .yRange = PlotRange{0.0, 1.02}};
  PlotSeries exact = plot::sampled("exact", referenceColour, range,
                                   [&](double z) { return referenceVisibility(probe.region, z); });
  exact.lineWidth = plot::normal;
  const std::vector<double> depths = exact.x;
  plot.series.push_back(std::move(exact));
  std::set<int> counts{1, 2, 4, 8, 16};
  if (resultOf(probe, "csm")) counts.insert(used.terms);
  for (const int terms : counts) {
    csm::CsmParameters parameters = used;
    parameters.terms = terms;
    PlotSeries series{"M = " + std::to_string(terms),
                      plot::tint(fourierColour, 0.25 + 0.15 * std::log2(2.0 * terms)),
                      SeriesStyle::Line, depths, visibilitiesOf(probe.region, parameters, depths)};
    series.lineWidth = terms == used.terms ? plot::thick : plot::thin;
    plot.series.push_back(std::move(series));
  }
  plot.markers.push_back(plot::receiverMarker(probe.receiver));
  return plot;
}

}  // namespace umbra
