// Converts VTK's cameras to the program's.
#pragma once

#include "filters/core/scene/Camera.h"

class vtkCamera;

namespace umbra {

// The camera's position and view, which an interactor may have moved.
Camera cameraOf(vtkCamera& camera);

}  // namespace umbra
