// What Mesa's software renderer does not keep in order.
#pragma once

#include <string_view>

#include "filters/gpu/gl/OpenGL.h"

namespace umbra::gl {

// Call it between draws and a compute shader that reads what they drew: llvmpipe starts the shader
// while the draws are still at work. For other drivers it does nothing.
inline void finishDraws() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (name && std::string_view(name).find("llvmpipe") != std::string_view::npos) glFinish();
}

}  // namespace umbra::gl
