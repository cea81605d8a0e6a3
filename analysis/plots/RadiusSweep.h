// The error of every technique at one place, over the filter's radius.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

struct RadiusSweep {
  std::vector<int> radii;         // texels, ascending from 0
  std::vector<double> reference;  // one for each radius
  // The techniques that can be stored in the format, in the request's order, and their errors,
  // visibility minus reference, for each radius.
  std::vector<std::shared_ptr<const Technique>> techniques;
  std::vector<std::vector<double>> errors;
};

// Takes the request's probe again with every radius from 0 to `largest`. Place, receiver, format
// and the kernel's shape stay; "none" counts as box. The receiver keeps its bias whatever the
// radius. `eachStep` is called before each radius; an exception that it throws ends the sweep. The
// cost of a radius grows with its square.
RadiusSweep sweepRadius(
    const ProbeRequest& request, int largest = Kernel::largestRadius,
    const std::function<void()>& eachStep = [] {});

// `selected` is the id of the technique whose curve is emphasised; `radius` is the present one.
Plot radiusPlot(const RadiusSweep& sweep, std::string_view selected, int radius);

}  // namespace umbra
