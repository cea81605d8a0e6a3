// What is kept of a picture's frame, so that any of its pixels can be probed later.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/frame/FrameReads.h"
#include "datasets/session/Session.h"
#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Image.h"
#include "filters/core/maps/SurfaceImage.h"
#include "ui/picture/Footprint.h"

namespace umbra {

struct FrameEvidence {
  SurfaceImage surfaces;
  std::vector<Cascade> cascades;
  std::vector<DepthMap> maps;  // of every cascade; none where they were not asked for
  std::shared_ptr<const Technique> technique;  // as the frame adapted it
};

// Whether two frames of one scene and light have the same map, whatever their cameras.
bool sameMap(const FrameSettings& a, const FrameSettings& b);

// A pane's own probe.
struct FrameProbe {
  Probe probe;
  std::vector<Eigen::Vector3d> footprint;  // world, the outline of the region on the surface
};

// Probes the frame's technique alone, with the settings that the frame was drawn with, at the
// pixel's surface or at another `receiver` depth. `mapOf` gives a cascade's map; `plane` is the
// surface around the pixel. None where the pixel shows no surface that the map covers.
std::optional<FrameProbe> probeFrame(const FrameEvidence& evidence, const FrameSettings& frame,
                                     const MapOf& mapOf, const Pixel& pixel,
                                     const std::optional<double>& receiver,
                                     const std::optional<Plane>& plane);

}  // namespace umbra
