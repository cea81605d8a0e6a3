// Meshes with values as PLY files.
#pragma once

#include <filesystem>

#include "filters/core/scene/FieldMesh.h"

namespace umbra {

// Writes binary PLY with a property for each field under its name ("property float bleeding"), and
// for faces "property int object", the number of the object. Throws BadOutput, and leaves an
// earlier `file` as it is then.
void writePly(const FieldMesh& mesh, const std::filesystem::path& file);

}  // namespace umbra
