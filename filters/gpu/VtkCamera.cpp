#include "filters/gpu/VtkCamera.h"

#include <vtkCamera.h>

namespace umbra {

Camera cameraOf(vtkCamera& source) {
  Camera camera;
  camera.position = Eigen::Map<const Eigen::Vector3d>(source.GetPosition());
  camera.target = Eigen::Map<const Eigen::Vector3d>(source.GetFocalPoint());
  camera.up = Eigen::Map<const Eigen::Vector3d>(source.GetViewUp());
  camera.viewAngle = source.GetViewAngle();
  return camera;
}

}  // namespace umbra
