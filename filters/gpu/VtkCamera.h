// Cameras of VTK as the program has them.
#pragma once

#include "filters/core/scene/Camera.h"

class vtkCamera;

namespace umbra {

// Where it stands and looks, as an interactor may have moved it.
Camera cameraOf(vtkCamera& camera);

}  // namespace umbra
