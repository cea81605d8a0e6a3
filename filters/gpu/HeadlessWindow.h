// An OpenGL window that needs no display: EGL on Mesa's surfaceless platform.
#pragma once

#include <vtkSmartPointer.h>

class vtkRenderWindow;

namespace umbra {

// Off-screen, core profile 4.5 or better, no multisampling. Throws NoOpenGL with what is missing
// (EGL library, platform, device or context version) and what would bring it.
vtkSmartPointer<vtkRenderWindow> makeHeadlessWindow(int width, int height);

}  // namespace umbra
