// Meshes with values as VTK PolyData files.
#pragma once

#include <filesystem>

#include "filters/core/scene/FieldMesh.h"

namespace umbra {

// Writes XML with its arrays appended in binary: point data and cell data under the fields' names,
// with "bleeding" active, cell data "object", and field data "objects" with the objects' names in
// that order. Throws BadOutput, and leaves an earlier `file` as it is then.
void writeVtp(const FieldMesh& mesh, const std::filesystem::path& file);

}  // namespace umbra
