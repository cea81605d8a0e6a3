// The parts of a view that was held fast, and the windows of the light's map that hold them, drawn
// as lines in the scene: for whoever looks from elsewhere.
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

  // In the colours of the cascades' view mode: each part of the view of `camera`, and thinner its
  // window between the light's near and far plane.
  void show(const Camera& camera, double aspect, const std::vector<Cascade>& cascades);
  void hide();

  // For tests: views, then windows.
  std::array<vtkActor*, 2> actors() const { return {views_, windows_}; }

 private:
  vtkSmartPointer<vtkPolyData> viewData_, windowData_;
  vtkSmartPointer<vtkActor> views_, windows_;
};

}  // namespace umbra
