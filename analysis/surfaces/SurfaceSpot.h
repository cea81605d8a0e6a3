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
  std::size_t object = 0;  // index of the scene's object
  bool twoSided = false;   // part of no closed body: it is a sheet, lit and seen from both sides
};

// The triangle nearest to `point` (world). Nothing where it is farther away than the depth of a
// picture can err: 1e-3 of the scene's extent plus 1e-3 of the point's distance from its centre.
std::optional<SurfaceSpot> surfaceNear(const Scene& scene, const Eigen::Vector3d& point);

}  // namespace umbra
