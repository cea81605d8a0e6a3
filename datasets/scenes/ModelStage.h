// A model from elsewhere, of any size and place, set on a ground in the light.
#pragma once

#include <vector>

#include "filters/core/scene/Scene.h"

namespace umbra {

struct Stage {
  double size = 4.0;       // of the model's longest side, world units
  double turn = 0.0;       // degrees about the vertical, before the camera sees it
  double viewFrom = 28.0;  // degrees that the camera stands to the right of +z
  double viewUp = 20.0;    // degrees that it looks down
  double sunFrom = -40.0;  // degrees that the light stands to the right of +z
  double sunUp = 52.0;     // its height above the horizon, degrees
};

// Scaled, centred over the origin, its lowest point on y = 0, with a paved ground, a directional
// light and a camera that holds model and shadow.
Scene stagedScene(std::vector<SceneObject> objects, const Stage& stage);

}  // namespace umbra
