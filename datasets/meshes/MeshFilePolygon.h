// Polygons as triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace umbra::meshfile {

// Corners in order round the polygon, three or more, finite; as many triangles as corners less
// two, of indices into `corners`, in the same sense of turning. Convex polygons become a fan,
// hollow ones lose one ear after another; a polygon that crosses itself gives some triangles.
std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Eigen::Vector3d> corners);

}  // namespace umbra::meshfile
