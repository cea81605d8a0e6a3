// Meshes with values as VTK PolyData files.
#pragma once

#include <filesystem>

#include "filters/core/scene/FieldMesh.h"

namespace umbra {

// XML, its arrays appended in binary: point data and cell data by the fields' names, "bleeding"
// active; cell data "object", and field data "objects", their names in that order. Throws
// BadOutput; what stood at `file` stays then.
void writeVtp(const FieldMesh& mesh, const std::filesystem::path& file);

}  // namespace umbra
