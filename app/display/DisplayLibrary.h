// Finds and loads the library that implements Display.
#pragma once

#include "app/display/Display.h"

namespace umbra {

// The library itself stays loaded, because neither Qt nor OpenGL drivers can be unloaded. Throws
// NoOpenGL that names the library when it or what it needs is not installed.
std::unique_ptr<Display> loadDisplay();

}  // namespace umbra
