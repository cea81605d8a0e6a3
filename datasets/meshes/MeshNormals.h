// Computes normals for triangles that have none.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "filters/core/scene/Scene.h"
#include "filters/core/support/Progress.h"

namespace umbra {

inline constexpr double usualCrease = 40.0;  // degrees

// A mesh of the given triangles, whose normals are smooth over edges that bend by less than
// `crease` degrees and break at sharper ones; vertices on a break are doubled. Faces count by the
// angle that they span at the vertex, so that how a polygon was cut into triangles does not show.
// Triangles of no area are left out. Indices must be valid and positions finite.
Mesh withNormals(std::span<const Eigen::Vector3f> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles,
                 double crease = usualCrease, const Progress& progress = {});

}  // namespace umbra
