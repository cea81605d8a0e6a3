// What a pane makes of the probed point.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "analysis/probe/Probe.h"

namespace umbra {

struct DrawnPane;
struct ProbeReport;
struct ShownPane;
class SessionController;

struct PaneFigures {
  TechniqueResult result;  // with the pane's own settings
  double reference = 0.0;
  Kernel kernel;
  // World: the outline of the pane's region on the surface; empty where it is the report's.
  std::vector<Eigen::Vector3d> footprint;
};

// The figures of a pane at the point of `report`: the report's own where the active pane has the
// same settings, else those that the pane's picture gives; none without a picture (null), and where
// the point is not in sight.
std::optional<PaneFigures> figuresOf(const ShownPane& pane, const DrawnPane* drawn,
                                     const ProbeReport& report,
                                     const SessionController& controller);

}  // namespace umbra
