#include "analysis/plots/RadiusSweep.h"

#include <optional>
#include <string>

#include "analysis/plots/PlotParts.h"
#include "analysis/plots/ProbePlots.h"

namespace umbra {
namespace {

ProbeRequest withRadius(const ProbeRequest& request, int radius) {
  ProbeRequest changed = request;
  if (changed.kernel.shape == KernelShape::None) changed.kernel.shape = KernelShape::Box;
  changed.kernel.radius = radius;
  // The table's box is the footprint, which holds the kernel's window.
  if (changed.read.filter == ReadFilter::SummedArea)
    for (Footprint* box :
         {&changed.read.footprint, changed.seam ? &changed.seam->read.footprint : nullptr})
      if (box) box->x = box->y = 2.0 * radius + 1.0;
  return changed;
}

}  // namespace

RadiusSweep sweepRadius(const ProbeRequest& request, int largest,
                        const std::function<void()>& eachStep) {
  RadiusSweep sweep;
  for (int radius = 0; radius <= largest; ++radius) {
    eachStep();
    const Probe probe = takeProbe(withRadius(request, radius));
    if (radius == 0) {
      for (const TechniqueResult& result : probe.techniques)
        sweep.techniques.push_back(result.technique);
      sweep.errors.resize(sweep.techniques.size());
    }
    sweep.radii.push_back(radius);
    sweep.reference.push_back(probe.reference);
    for (std::size_t i = 0; i < probe.techniques.size(); ++i)
      sweep.errors[i].push_back(probe.techniques[i].error);
  }
  return sweep;
}

Plot radiusPlot(const RadiusSweep& sweep, std::string_view selected, int radius) {
  Plot plot{.name = "radius",
            .title = "Error over the filter's radius",
            .xLabel = "radius (texels)",
            .yLabel = "visibility − exact",
            .wholeX = true};
  plot.xRange = PlotRange{0.0, sweep.radii.empty() ? 1.0 : double(sweep.radii.back())};
  const std::vector<double> x(sweep.radii.begin(), sweep.radii.end());
  plot.markers.push_back(
      {MarkerAxis::Horizontal, 0.0, "exact", std::string(referenceColour), false});
  std::optional<PlotSeries> emphasised;
  for (std::size_t i = 0; i < sweep.techniques.size(); ++i) {
    const TechniqueInfo& info = sweep.techniques[i]->info();
    PlotSeries series{plot::legendName(info), std::string(info.colour),
                      SeriesStyle::Line,      x,
                      sweep.errors[i],        plot::thin};
    if (info.id == selected) {
      series.lineWidth = plot::thick;
      emphasised = std::move(series);
    } else {
      plot.series.push_back(std::move(series));
    }
  }
  if (emphasised)
    plot.series.push_back(std::move(*emphasised));  // this curve lies on top of the others
  plot.markers.push_back({MarkerAxis::Vertical, double(radius), "radius " + std::to_string(radius),
                          std::string(probeColour), true});
  return plot;
}

}  // namespace umbra
