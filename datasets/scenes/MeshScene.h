// Any mesh file as a scene, on a ground plane.
#pragma once

#include <filesystem>

#include "datasets/meshes/MeshFile.h"
#include "filters/core/scene/Scene.h"

namespace umbra {

// Centres the mesh, scales it to a height or width of about 4, sets it on the ground, and fits
// light and camera. Throws BadInput as readMeshFile does.
Scene sceneFromMeshFile(const std::filesystem::path& file, MeshReport* report = nullptr);

}  // namespace umbra
