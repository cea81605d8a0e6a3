// Newell's teapot as surfaces of revolution.
#pragma once

#include "datasets/scenes/MeshBuilder.h"

namespace umbra::scenes {

// It stands on the origin with its spout towards +x, `height` tall to the top of the knob.
Mesh teapot(double height);

}  // namespace umbra::scenes
