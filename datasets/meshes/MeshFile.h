// Any mesh file: OBJ, PLY, OFF or STL.
#pragma once

#include <filesystem>

#include "filters/core/scene/Scene.h"

namespace umbra {

// It is logged as a warning where faces were dropped and the caller does not ask for the report.
struct MeshReport {
  std::size_t degenerateFaces = 0, nonFiniteFaces = 0;  // dropped
  bool normalsComputed = false;  // because they were absent, or several at one vertex
};

// The triangles, in the file's own coordinates. Throws BadInput that names the file: unknown
// extension, unreadable, no faces, truncated (with what was read against what was promised),
// indices out of range.
Mesh readMeshFile(const std::filesystem::path& file, MeshReport* report = nullptr);

}  // namespace umbra
