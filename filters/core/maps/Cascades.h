// Parallel-split cascades: the view cut along its depth, and for each part a window of the light's
// map that becomes a map of its own (Zhang et al. 2006).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "filters/core/scene/Light.h"
#include "filters/core/settings/FrameSettings.h"

namespace umbra {

struct Cascade {
  // Of the view that it holds: distances along the camera's axis, world units. Where one cascade
  // ends the next begins. The first starts at 0 where the camera stands among the bounds.
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
  // Where it begins to go over into the next one: the last `seam` part of its depth.
  double seamDistance(double seam) const {
    return farDistance - seam * (farDistance - nearDistance);
  }
};

// The count + 1 ends of the parts between two distances, 0 < near < far: λ times the logarithmic
// and 1 − λ times the even cut (Zhang 2006, eq. 3).
std::vector<double> practicalSplits(double near, double far, int count, double lambda);

// One cascade for each part of the camera's view of `bounds` (world), 1 to
// CascadeSettings::largestCount. One cascade is the whole frame, whatever the camera. A window is
// never larger than the whole map; it holds its part of the bounds with the seam before it and
// `reach` texels around, as many as a filter reads beside a position.
//
// Shadows stand still while the camera moves or turns: a directional light's window holds the
// sphere about its part, which does not change as the camera turns, a spot light's window grows in
// steps; either moves by whole texels of a map of `map.size`. The range that is split, which
// follows the camera's distance from the bounds, changes in steps too, by a fifth each.
// `aspect` is the picture's width over its height.
std::vector<Cascade> fitCascades(const LightFrame& light, const Camera& camera, double aspect,
                                 const Eigen::AlignedBox3d& bounds, const MapSettings& map,
                                 int reach = 0);

// The eight corners of a camera's view between two distances along its axis, world: first the four
// near ones, counter-clockwise from the bottom left, then the four far ones.
std::array<Eigen::Vector3d, 8> viewCorners(const Camera& camera, double aspect, double near,
                                           double far);

}  // namespace umbra
