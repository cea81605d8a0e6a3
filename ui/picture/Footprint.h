// The filter region as a patch on the surface that it belongs to.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "filters/core/maps/Region.h"
#include "filters/core/scene/Light.h"

namespace umbra {

using Plane = Eigen::Hyperplane<double, 3>;

// The outline (world, closed: the last point joins the first) of the texels of `region`, of a map
// of `size` texels a side: where the light's rays through its border meet `surface`; without one,
// or where they miss it, at the receiver's depth `z` in [0,1].
std::vector<Eigen::Vector3d> footprintOf(const Region& region, int size, double z,
                                         const LightFrame& frame,
                                         const std::optional<Plane>& surface);

// The plane through a point and the nearer of its neighbours on either side, along both axes of
// the picture (world). None where they are no plane: at a silhouette, or with neighbours missing.
std::optional<Plane> planeThrough(const Eigen::Vector3d& point,
                                  const std::vector<std::optional<Eigen::Vector3d>>& leftRight,
                                  const std::vector<std::optional<Eigen::Vector3d>>& upDown);

}  // namespace umbra
