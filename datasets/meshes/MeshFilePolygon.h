// Polygons as triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace umbra::meshfile {

// Triangulates a polygon of at least three finite corners, in order around it. The result has two
// triangles fewer than there are corners, of indices into `corners`, with the same sense of
// turning. Convex polygons become a fan; of others one ear after another is cut off. A polygon that
// crosses itself gives some triangles.
std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Eigen::Vector3d> corners);

}  // namespace umbra::meshfile
