// Which surface of a scene a point lies on.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "filters/core/scene/Scene.h"

namespace umbra {

struct SurfaceSpot {
  Eigen::Vector3d point;   // world, moved onto the triangle's plane
  Eigen::Vector3d normal;  // world, unit, of the triangle
  std::size_t object = 0;  // of the scene, by its place
  bool twoSided = false;   // a sheet, lit and seen from both sides: it bounds no closed body
};

// The triangle nearest to `point` (world). None where it is farther away than the depth of a
// picture can err: 1e-3 of the scene's extent and of the point's distance from its centre.
std::optional<SurfaceSpot> surfaceNear(const Scene& scene, const Eigen::Vector3d& point);

}  // namespace umbra
