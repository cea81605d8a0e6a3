// Whether a mesh bounds solid bodies, whose insides nobody outside can see.
#pragma once

#include "filters/core/Scene.h"

namespace umbra {

// Every edge is shared by exactly two triangles that run along it in opposite directions, and
// every connected part encloses a positive volume: its triangles are counter-clockwise seen from
// outside. Positions that are equal count as one.
bool isClosedBody(const Mesh& mesh);

}  // namespace umbra
