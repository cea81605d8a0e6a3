// Any mesh as a scene: OBJ, PLY, OFF or STL on a ground plane.
#pragma once

#include <filesystem>

#include "filters/core/Scene.h"

namespace umbra {

// Logged as a warning where faces were dropped and the caller does not ask for it.
struct MeshReport {
  std::size_t degenerateFaces = 0, nonFiniteFaces = 0;  // dropped
  bool normalsComputed = false;                         // where absent, or several at one vertex
};

// Centred, scaled to a height or width of about 4 and set on the ground, with light and camera
// fitted. Throws BadInput that names the file: unknown extension, unreadable, no faces, truncated
// (with what was read against what was promised), indices out of range.
Scene sceneFromMeshFile(const std::filesystem::path& file, MeshReport* report = nullptr);

// The triangles only, in the file's own coordinates.
Mesh readMeshFile(const std::filesystem::path& file, MeshReport* report = nullptr);

}  // namespace umbra
