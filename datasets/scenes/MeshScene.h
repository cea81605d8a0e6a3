// Any mesh file as a scene, on a ground plane.
#pragma once

#include <filesystem>

#include "datasets/meshes/MeshFile.h"
#include "filters/core/scene/Scene.h"

namespace umbra {

// Centred, scaled to a height or width of about 4 and set on the ground, with light and camera
// fitted. Throws BadInput as readMeshFile does.
Scene sceneFromMeshFile(const std::filesystem::path& file, MeshReport* report = nullptr);

}  // namespace umbra
