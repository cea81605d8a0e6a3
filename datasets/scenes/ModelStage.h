// Sets a model of any size and place on a ground in the light.
#pragma once

#include <vector>

#include "datasets/meshes/MeshFileReader.h"
#include "filters/core/scene/Scene.h"

namespace umbra {

struct ModelStage {
  double size = 4.0;       // the model's longest side, world units
  bool zIsUp = false;      // in the model's file; otherwise y is
  double turn = 0.0;       // degrees that the model is turned about the vertical
  double viewFrom = 28.0;  // degrees that the camera stands to the right of +z
  double viewUp = 20.0;    // degrees that it looks down
  double sunFrom = -40.0;  // degrees that the light stands to the right of +z
  double sunUp = 52.0;     // its height above the horizon, degrees
};

// A part of a model that has a name and a material of its own.
struct ModelPart {
  std::string name;
  Material material;
  std::vector<meshfile::Triangle> triangles;  // some of the model's
};

// Scales the parts, centres them over the origin with their lowest point on y = 0, and adds a paved
// ground, a directional light and a camera whose view holds model and shadow.
Scene stagedScene(const meshfile::RawMesh& raw, const std::vector<ModelPart>& parts,
                  const ModelStage& stage, const Progress& progress = {});

}  // namespace umbra
