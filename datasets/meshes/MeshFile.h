// Any mesh file: OBJ, PLY, OFF, STL or glTF.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/scene/Scene.h"

namespace umbra {

// Which axis of a mesh file points up.
enum class UpAxis { Y, Z };
std::string nameOf(UpAxis up);  // "y" or "z"
// Throws BadInput that begins with `where` for any other name.
UpAxis upAxisFrom(std::string_view name, std::string_view where);

// What was left out or guessed on the way.
struct MeshReport {
  std::size_t degenerateFaces = 0;  // without area: left out
  std::size_t shortFaces = 0;       // of fewer than three vertices: left out
  std::size_t nonFiniteFaces = 0;   // with coordinates that are not finite numbers: left out
  std::size_t crossedFaces = 0;     // polygons that cross themselves or are bent, cut somehow
  std::size_t longFaces = 0;        // polygons of too many corners, cut somehow
  bool normalsComputed = false;     // because they were absent, or several at one vertex
  std::vector<std::string> notes;   // one clause for each other doubtful reading

  // All of it in one line for people; empty where nothing was in doubt.
  std::string summary() const;
};

// The triangles, in the file's own coordinates. Throws BadInput that names the file: unknown
// extension, unreadable, no faces, truncated (with what was read against what was promised),
// indices out of range. The report's summary is logged as a warning where the caller does not ask
// for the report.
Mesh readMeshFile(const std::filesystem::path& file, MeshReport* report = nullptr);

}  // namespace umbra
