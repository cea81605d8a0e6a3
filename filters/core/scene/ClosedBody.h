// Whether a mesh bounds solid bodies, whose insides nobody outside can see.
#pragma once

#include <vector>

#include "filters/core/scene/Scene.h"

namespace umbra {

// Tells for each triangle whether the connected part of the mesh that it belongs to bounds a solid
// body. Every edge of such a part is shared by exactly two triangles that run along it in opposite
// directions, and the part encloses a positive volume: its triangles are counter-clockwise seen
// from outside. Positions that are equal count as one.
std::vector<bool> closedTriangles(const Mesh& mesh);

// Whether all triangles bound solid bodies.
bool isClosedBody(const Mesh& mesh);

}  // namespace umbra
