// Newell's teapot, turned from its outlines.
#pragma once

#include "datasets/scenes/MeshBuilder.h"

namespace umbra::scenes {

// Stands on the origin with its spout towards +x, `height` tall to the top of the knob.
Mesh teapot(double height);

}  // namespace umbra::scenes
