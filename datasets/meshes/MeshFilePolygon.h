// Cuts a polygon of a mesh file into triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace umbra::meshfile {

struct Triangulated {
  // Each triangle's corners, as indices of the polygon's, in the polygon's sense of turning. Where
  // the polygon is simple, the triangles cover it and nothing else; ones without area are left out.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // Whether the polygon crosses itself, so that no set of triangles is right.
  bool crossesItself = false;
  bool hasTooManyCorners = false;  // to be cut rightly in time
};

// Ear clipping (Meisters 1975) with the care for polygons that touch themselves that Held's FIST
// takes (2001): a bridge to a hole runs to and fro along the same edge, a corner may stand several
// times. A corner is cut off where no edge of what is left meets the inside of its triangle; a
// corner without an area is dropped. The corners may be a little off one plane: they are seen along
// the axis to which the polygon is most perpendicular.
// `testsLeft` counts down the tests of an edge against a corner's triangle, whose number grows with
// the square of the corners; when it is 0, what is left of the polygon is cut as if it were convex.
Triangulated triangulated(std::span<const Eigen::Vector3d> corners, std::uint64_t& testsLeft);

// As many tests as take about a second.
inline constexpr std::uint64_t manyTests = 600'000'000;

}  // namespace umbra::meshfile
