// A probe of a pane's own frame.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "analysis/probe/Probe.h"
#include "datasets/session/Session.h"
#include "filters/core/frame/FrameSnapshot.h"
#include "ui/picture/Footprint.h"

namespace umbra {

struct FrameProbe {
  Probe probe;
  std::vector<Eigen::Vector3d> footprint;  // world, the outline of the region on the surface
};

// Probes the frame's technique alone, with the settings that the frame was drawn with, at the
// pixel's surface or at another `receiver` depth. `plane` is the surface around the pixel. None
// where the pixel shows no surface that the map covers.
std::optional<FrameProbe> probeFrame(const FrameSnapshot& frame, const Pixel& pixel,
                                     const std::optional<double>& receiver,
                                     const std::optional<Plane>& plane);

}  // namespace umbra
