// Parallel-split cascades: the view cut along its depth, and for each part a window of the light's
// map that becomes a map of its own (Zhang et al. 2006).
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "filters/core/FrameSettings.h"
#include "filters/core/Light.h"

namespace umbra {

struct Cascade {
  // Of the view that it holds: distances along the camera's axis, world units.
  double nearDistance = 0.0, farDistance = 0.0;
  // Its square window of the whole frame's map: left and top edge and side, in the whole map's
  // (u, v). The window may reach beyond the map's edges.
  double left = 0.0, top = 0.0, side = 1.0;
  // The light's frame drawn into that window. Direction, near and far plane are the whole frame's,
  // so that depths of all cascades compare.
  LightFrame frame;

  // From the whole map's (u, v) to this one's.
  double u(double whole) const { return (whole - left) / side; }
  double v(double whole) const { return (whole - top) / side; }
};

// The count + 1 ends of the parts between two distances, 0 < near < far: λ times the logarithmic
// and 1 − λ times the even cut (Zhang 2006, eq. 3).
std::vector<double> practicalSplits(double near, double far, int count, double lambda);

// One cascade for each part of the camera's view of `bounds` (world). One cascade is the whole
// frame. A window holds its part's bounding sphere and moves by whole texels of `map.size`, so that
// shadows stand still while the camera moves or turns; the range that is split changes in steps for
// the same reason. `aspect` is the picture's width over its height.
std::vector<Cascade> fitCascades(const LightFrame& light, const Camera& camera, double aspect,
                                 const Eigen::AlignedBox3d& bounds, const MapSettings& map);

}  // namespace umbra
