// Any mesh file as a scene, on a ground plane.
#pragma once

#include <filesystem>

#include "datasets/meshes/MeshFile.h"
#include "filters/core/scene/Scene.h"
#include "filters/core/support/Progress.h"

namespace umbra {

// Centres the mesh, scales its longest side to 4, sets it on the ground, and fits light and camera.
// What the file names (objects and groups, materials, solids, nodes) becomes an object each; a file
// that names nothing, or too many things to be told apart, becomes one of the file's name. Throws
// BadInput as readMeshFile does.
Scene sceneFromMeshFile(const std::filesystem::path& file, UpAxis up = UpAxis::Y,
                        MeshReport* report = nullptr, const Progress& progress = {});

}  // namespace umbra
