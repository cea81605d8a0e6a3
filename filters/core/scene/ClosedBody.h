// Whether a mesh bounds solid bodies, whose insides nobody outside can see.
#pragma once

#include <vector>

#include "filters/core/scene/Scene.h"

namespace umbra {

// Of each triangle: whether the connected part of the mesh that it belongs to bounds a solid body.
// Every edge of such a part is shared by exactly two triangles that run along it in opposite
// directions, and it encloses a positive volume: its triangles are counter-clockwise seen from
// outside. Positions that are equal count as one.
std::vector<bool> closedTriangles(const Mesh& mesh);

// Whether all of them do.
bool isClosedBody(const Mesh& mesh);

}  // namespace umbra
