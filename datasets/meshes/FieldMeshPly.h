// Meshes with values as PLY files.
#pragma once

#include <filesystem>

#include "filters/core/scene/FieldMesh.h"

namespace umbra {

// Binary PLY with a property of its name for each field ("property float bleeding"), and for faces
// "property int object", the number of the object. Throws BadOutput; what stood at `file` stays
// then.
void writePly(const FieldMesh& mesh, const std::filesystem::path& file);

}  // namespace umbra
