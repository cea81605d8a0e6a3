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
  // The part of the view that it holds: distances along the camera's axis, world units. Where one
  // cascade ends the next begins. The first starts at 0 where the camera stands among the bounds.
  double nearDistance = 0.0, farDistance = 0.0;
  // Its square window of the whole frame's map: left edge, top edge and side, in the whole map's
  // (u, v). The window may reach beyond the map's edges.
  double left = 0.0, top = 0.0, side = 1.0;
  // The light's frame drawn into that window. Direction, near and far plane are the whole frame's,
  // so that depths of all cascades compare.
  LightFrame frame;

  // The whole map's (u, v) in this cascade's.
  double u(double whole) const { return (whole - left) / side; }
  double v(double whole) const { return (whole - top) / side; }
  // The distance at which it begins to go over into the next one: the last `seam` part of its
  // depth.
  double seamDistance(double seam) const {
    return farDistance - seam * (farDistance - nearDistance);
  }
};

// The count + 1 distances that bound the parts of a view between `near` and `far`, 0 < near < far:
// λ times the logarithmic cut plus 1 − λ times the even cut (Zhang 2006, eq. 3).
std::vector<double> practicalSplits(double near, double far, int count, double lambda);

// Cuts the camera's view of `bounds` (world) into parts, 1 to CascadeSettings::largestCount, with
// one cascade for each. A single cascade is the whole frame, whatever the camera. A window is never
// larger than the whole map; it holds its part of the bounds, the seam before that part, and
// `reach` texels around it, as many as a filter reads beside a position.
//
//
// Shadows stand still while the camera moves or turns. The window of a directional light holds the
// sphere about its part, which does not change as the camera turns; the window of a spot light
// grows in steps. Either moves by whole texels of a map of `map.size`. The range that is split
// follows the camera's distance from the bounds in steps, too, each a fifth of the range. `aspect`
// is the picture's width over its height.
std::vector<Cascade> fitCascades(const LightFrame& light, const Camera& camera, double aspect,
                                 const Eigen::AlignedBox3d& bounds, const MapSettings& map,
                                 int reach = 0);

// The eight corners of a camera's view between two distances along its axis, world: first the four
// near ones, counter-clockwise from the bottom left, then the four far ones.
std::array<Eigen::Vector3d, 8> viewCorners(const Camera& camera, double aspect, double near,
                                           double far);

}  // namespace umbra
