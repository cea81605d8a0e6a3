// OpenGL's functions, as the VTK in use loads them: GLEW up to VTK 9.3, glad from 9.4 on. Nothing
// else includes either.
#pragma once

#include <vtkOpenGLRenderWindow.h>
#include <vtkVersionMacros.h>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240914)
#define UMBRA_VTK_LOADS_SYMBOLS 1
#include <vtk_glad.h>
#else
#define UMBRA_VTK_LOADS_SYMBOLS 0
#include <vtk_glew.h>
#endif

#ifndef GLAPIENTRY  // the calling convention of what OpenGL calls back; GLEW's name for it
#define GLAPIENTRY APIENTRY
#endif

namespace umbra::gl {

// Whether the context that is current is of OpenGL 4.5 or later; its functions must be loaded.
inline bool hasVersion45() {
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return major > 4 || (major == 4 && minor >= 5);
}

}  // namespace umbra::gl
