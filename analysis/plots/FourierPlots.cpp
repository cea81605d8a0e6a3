#include "analysis/plots/FourierPlots.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

constexpr std::string_view fourierColour = "#8c6d31";
constexpr std::string_view scaleColour = "#7b4fa3";
constexpr int defaultTerms = 4;

double frequency(int k) {
  return std::numbers::pi * (2 * k - 1);
}

// The largest value of the series and where it is, on the lit side of the step; it is symmetric
// about t = ½.
std::pair<double, double> highestOf(const FourierStep& series) {
  const int steps = 256 * series.terms();
  std::pair<double, double> highest{0.0, 0.0};
  for (int i = 0; i <= steps; ++i) {
    const double t = 0.5 * i / steps;
    if (series(t) > highest.second) highest = {t, series(t)};
  }
  return highest;
}

double attenuationOf(const Probe& probe) {
  const TechniqueResult* csm = plot::resultNamed(probe, "csm");
  return csm ? plot::parameterOf(*csm->technique, "attenuation", 0.0) : 0.0;
}

int termsOf(const Probe& probe) {
  const TechniqueResult* csm = plot::resultNamed(probe, "csm");
  return csm ? int(plot::parameterOf(*csm->technique, "terms", defaultTerms)) : defaultTerms;
}

}  // namespace

FourierStep::FourierStep(int terms, double attenuation) {
  for (int k = 1; k <= terms; ++k) {
    const double share = double(k) / terms;
    coefficients_.push_back(2.0 * std::exp(-attenuation * share * share) / frequency(k));
  }
  offset_ = findOffset();
}

double FourierStep::operator()(double t) const {
  double sum = 0.5;
  for (int k = 1; k <= terms(); ++k) sum += coefficients_[k - 1] * std::sin(frequency(k) * t);
  return sum;
}

// The fastest wave is longer than 1/M, so that steps of 1/(256 M) rise by no more than one crossing
// each; within one the series rises, and halving finds the crossing or the highest point.
double FourierStep::findOffset() const {
  const double step = 1.0 / (256.0 * terms());
  double best = 0.0, bestAt = 0.0;
  for (double low = 0.0; low < 0.5; low += step) {
    if ((*this)(low) > best) {
      best = (*this)(low);
      bestAt = low;
    }
    if ((*this)(low + step) < 1.0) continue;
    double high = low + step;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      ((*this)(middle) < 1.0 ? low : high) = middle;
    }
    return high;
  }
  double low = std::max(0.0, bestAt - step), high = bestAt + step;
  for (int i = 0; i < 60; ++i) {  // thirds: the series has one maximum here
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    ((*this)(a) < (*this)(b) ? low : high) = (*this)(a) < (*this)(b) ? a : b;
  }
  return 0.5 * (low + high);
}

std::vector<double> FourierStep::over(const Region& region,
                                      const std::vector<double>& receivers) const {
  std::vector<double> values(receivers.size(), 0.5);
  for (int k = 1; k <= terms(); ++k) {
    double sine = 0.0, cosine = 0.0;
    for (const RegionTexel& texel : region.texels) {
      sine += texel.weight * std::sin(frequency(k) * texel.depth);
      cosine += texel.weight * std::cos(frequency(k) * texel.depth);
    }
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      const double phase = frequency(k) * receivers[i];
      values[i] += coefficients_[k - 1] * (std::cos(phase) * sine - std::sin(phase) * cosine);
    }
  }
  return values;
}

Plot fourierStepPlot(int terms, double attenuation) {
  const PlotRange range{-0.5, 0.5};
  const double shown = attenuation > 0.0 ? attenuation : 1.0;
  const FourierStep plain(terms, 0.0), damped(terms, shown);
  const FourierStep& used = attenuation > 0.0 ? damped : plain;
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
  return fourierStepPlot(termsOf(probe), attenuationOf(probe));
}

Plot fourierTermsPlot(const Probe& probe) {
  const double attenuation = attenuationOf(probe);
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
    const FourierStep step(terms, attenuation);
    std::vector<double> moved;
    for (double depth : depths) moved.push_back(depth - step.offset());
    PlotSeries series{"M = " + std::to_string(terms),
                      plot::tint(fourierColour, 0.25 + 0.15 * std::log2(2.0 * terms)),
                      SeriesStyle::Line, depths, step.over(probe.region, moved)};
    for (double& value : series.y) value = std::clamp(value, 0.0, 1.0);
    series.lineWidth = terms == termsOf(probe) ? plot::thick : plot::thin;
    plot.series.push_back(std::move(series));
  }
  plot.markers.push_back(plot::receiverMarker(probe.receiver));
  return plot;
}

}  // namespace umbra
