// A probe together with where it was taken: what every pane of the window shows.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/errors/Measure.h"
#include "analysis/probe/Probe.h"
#include "datasets/session/Session.h"
#include "ui/picture/Footprint.h"

namespace umbra {

struct ProbeReport {
  Probe probe;
  // What the probe was taken of, with its maps for as long as it is kept: on any thread.
  std::shared_ptr<const ProbeRequest> request;
  Pixel pixel;          // of the view (device pixels), or the texel of a depth file
  bool pinned = false;  // by a click; else it follows the pointer
  int cascade = 0;      // on whose map it lies
  bool facesLight = true;
  bool receiverByHand = false;  // dragged in a plot, not the surface's
  bool inSight = false;         // the picture's `pixel` shows the point
  // World, on the surface; absent for a depth file.
  std::optional<Eigen::Vector3d> point;
  std::optional<Plane> plane;              // world, the surface around the point
  std::vector<Eigen::Vector3d> footprint;  // world, the outline of the region on the surface
};

}  // namespace umbra
