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
  bool slow = false;       // the plot may take seconds and wants a thread of its own
};

// They are in the order in which a list shows them.
std::span<const ExplainingPlot> explainingPlots();

struct ExplainingInput {
  const ProbeRequest& request;  // what the probe was taken of
  const Probe& probe;
  std::string selected;  // id of the technique that the plot shows, for plots of one technique
  // The depths of the planes, nearest to the light first, of a scene that consists of planes across
  // the light.
  std::vector<double> planes;
};

// The plot of that name. Nothing where it has nothing to show: a region without occluders, a
// technique that stores nothing, a scene without planes, or an unknown name. `eachStep` is called
// between the steps of a slow plot; an exception that it throws ends it.
std::optional<Plot> explainingPlot(
    std::string_view name, const ExplainingInput& input,
    const std::function<void()>& eachStep = [] {});

}  // namespace umbra
