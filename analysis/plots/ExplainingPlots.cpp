#include "analysis/plots/ExplainingPlots.h"

#include "analysis/plots/ChebyshevPlots.h"
#include "analysis/plots/FourierPlots.h"
#include "analysis/plots/MapPlots.h"
#include "analysis/plots/PlanesForm.h"
#include "analysis/plots/PlotParts.h"
#include "analysis/plots/PowerPlots.h"
#include "analysis/plots/Precision.h"
#include "analysis/plots/RadiusSweep.h"

namespace umbra {
namespace {

using Make = std::optional<Plot> (*)(const ExplainingInput&, const std::function<void()>&);

struct Entry {
  ExplainingPlot plot;
  Make make;
};

std::optional<Plot> distance(const ExplainingInput& input, const std::function<void()>&) {
  return occluderDistancePlot(input.probe);
}

std::optional<Plot> planes(const ExplainingInput& input, const std::function<void()>&) {
  const auto prediction = predictPlanes(input.probe, input.planes);
  if (!prediction) return std::nullopt;
  return planesPlot(input.probe, *prediction);
}

std::optional<Plot> coverage(const ExplainingInput& input, const std::function<void()>&) {
  const auto prediction = predictPlanes(input.probe, input.planes);
  if (!prediction) return std::nullopt;
  return coveragePlot(input.probe, *prediction);
}

std::optional<Plot> radius(const ExplainingInput& input, const std::function<void()>& eachStep) {
  const RadiusSweep sweep = sweepRadius(input.request, Kernel::largestRadius, eachStep);
  return radiusPlot(sweep, input.selected, input.request.kernel.effectiveRadius());
}

std::optional<Plot> precision(const ExplainingInput& input, const std::function<void()>&) {
  const TechniqueResult* result = resultOf(input.probe, input.selected);
  if (!result || result->channels.empty()) return std::nullopt;
  return precisionPlot(precisionOf(input.request, result->technique));
}

template <Plot (*make)(const Probe&)>
std::optional<Plot> ofProbe(const ExplainingInput& input, const std::function<void()>&) {
  return make(input.probe);
}

constexpr Entry entries[] = {
    {{"chebyshev", "VSM over variance"}, ofProbe<varianceFamilyPlot>},
    {{"distance", "VSM over occluders' distance"}, distance},
    {{"planes", "Closed form of the planes"}, planes},
    {{"coverage", "Closed form over coverage"}, coverage},
    {{"radius", "Error over filter radius", true}, radius},
    {{"precision", "Stored against double", true}, precision},
    {{"map-histogram", "Depths of the whole map", true},
     [](const ExplainingInput& input, const std::function<void()>&) -> std::optional<Plot> {
       return mapHistogramPlot(input.request.map, input.probe);
     }},
    {{"fourier-step", "CSM: Fourier step and its ringing"}, ofProbe<fourierStepPlot>},
    {{"fourier-terms", "CSM: Fourier terms"}, ofProbe<fourierTermsPlot>},
    {{"power-family", "Power CDF: power functions"}, ofProbe<powerFamilyPlot>},
    {{"residual", "Power CDF: residual of the fit"}, ofProbe<residualPlot>},
};

}  // namespace

std::span<const ExplainingPlot> explainingPlots() {
  static const std::vector<ExplainingPlot> plots = [] {
    std::vector<ExplainingPlot> listed;
    for (const Entry& entry : entries) listed.push_back(entry.plot);
    return listed;
  }();
  return plots;
}

std::optional<Plot> explainingPlot(std::string_view name, const ExplainingInput& input,
                                   const std::function<void()>& eachStep) {
  for (const Entry& entry : entries)
    if (entry.plot.name == name) return entry.make(input, eachStep);
  return std::nullopt;
}

}  // namespace umbra
