// Colours out of the MTL files that accompany OBJ files.
#pragma once

#include <map>
#include <string>

#include "filters/core/scene/Scene.h"

namespace umbra {

// Reads by name the diffuse colour (Kd) and the strength and sharpness of the highlight (Ks, Ns).
// Everything else is skipped, and so is a line that cannot be understood. Colours are clamped to
// [0,1].
std::map<std::string, Material> materialsFrom(const std::string& content);

}  // namespace umbra
