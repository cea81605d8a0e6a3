// Lines in the scene that show the parts of a frozen view and the windows of the light's map that
// hold them, for a viewer who looks from elsewhere.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "filters/core/maps/Cascades.h"

class vtkPolyData;
class vtkRenderer;

namespace umbra {

class CascadeLines {
 public:
  CascadeLines();

  void addTo(vtkRenderer& renderer);
  void removeFrom(vtkRenderer& renderer);

  // Draws, in the colours of the cascades' view mode, each part of the view of `camera`, and with
  // thinner lines its window between the light's near and far plane.
  void show(const Camera& camera, double aspect, const std::vector<Cascade>& cascades);
  void hide();

  // For tests: the actor of the views, then that of the windows.
  std::array<vtkActor*, 2> actors() const { return {views_, windows_}; }

 private:
  vtkSmartPointer<vtkPolyData> viewData_, windowData_;
  vtkSmartPointer<vtkActor> views_, windows_;
};

}  // namespace umbra
