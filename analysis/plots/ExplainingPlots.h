// Every plot that explains one probe beyond its curves, distribution and histogram, by name.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

struct ExplainingPlot {
  std::string_view name;   // of the plot, for file names
  std::string_view title;  // for a list to choose from
  bool slow = false;       // may take seconds: wants a thread of its own
};

// In the order of a list.
std::span<const ExplainingPlot> explainingPlots();

struct ExplainingInput {
  const ProbeRequest& request;  // what the probe was taken of
  const Probe& probe;
  std::string selected;  // id of the technique that a plot is about, where it is about one
  // Of a scene that consists of planes across the light: their depths, nearest to the light first.
  std::vector<double> planes;
};

// The plot of that name. None where it has nothing to show: a region without occluders, a technique
// that stores nothing, a scene without planes, or an unknown name. `eachStep` is called between
// steps of a slow one; what it throws ends it.
std::optional<Plot> explainingPlot(
    std::string_view name, const ExplainingInput& input,
    const std::function<void()>& eachStep = [] {});

}  // namespace umbra
