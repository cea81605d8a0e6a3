#include "filters/gpu/CascadeLines.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "filters/gpu/ViewColours.h"

namespace umbra {
namespace {

using Corners = std::array<Eigen::Vector3d, 8>;

vtkSmartPointer<vtkActor> lineActor(vtkPolyData* data, float width) {
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  mapper->SetScalarModeToUseCellData();
  mapper->SetColorModeToDirectScalars();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(width);
  actor->PickableOff();
  actor->VisibilityOff();
  return actor;
}

// The view mode's colours are pale; lines need stronger ones to be seen on them.
std::array<unsigned char, 3> lineColour(std::size_t cascade) {
  std::array<unsigned char, 3> bytes{};
  for (std::size_t c = 0; c < 3; ++c)
    bytes[c] = static_cast<unsigned char>(0.72f * 255.0f * cascadeColours[cascade][c]);
  return bytes;
}

// Adds the twelve edges of boxes; corners go round one face and then round the opposite one.
void setBoxes(vtkPolyData& data, const std::vector<Corners>& boxes) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto lines = vtkSmartPointer<vtkCellArray>::New();
  const auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetNumberOfComponents(3);
  for (std::size_t box = 0; box < boxes.size(); ++box) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Eigen::Vector3d& corner : boxes[box]) points->InsertNextPoint(corner.data());
    for (int i = 0; i < 4; ++i) {
      for (const auto& [a, b] : {std::pair{i, (i + 1) % 4}, {4 + i, 4 + (i + 1) % 4}, {i, 4 + i}}) {
        lines->InsertNextCell({first + a, first + b});
        colours->InsertNextTypedTuple(lineColour(box).data());
      }
    }
  }
  data.SetPoints(points);
  data.SetLines(lines);
  data.GetCellData()->SetScalars(colours);
  data.Modified();
}

Corners windowCorners(const LightFrame& frame) {
  Corners corners;
  for (std::size_t i = 0; i < 8; ++i) {
    const double u = i % 4 == 1 || i % 4 == 2 ? 1.0 : 0.0, v = i % 4 >= 2 ? 1.0 : 0.0;
    corners[i] = frame.unproject(u, v, i < 4 ? 0.0 : 1.0);
  }
  return corners;
}

}  // namespace

CascadeLines::CascadeLines()
    : viewData_(vtkSmartPointer<vtkPolyData>::New()),
      windowData_(vtkSmartPointer<vtkPolyData>::New()),
      views_(lineActor(viewData_, 2.0f)),
      windows_(lineActor(windowData_, 1.0f)) {}

void CascadeLines::addTo(vtkRenderer& renderer) {
  for (vtkActor* actor : actors()) renderer.AddActor(actor);
}

void CascadeLines::removeFrom(vtkRenderer& renderer) {
  for (vtkActor* actor : actors()) renderer.RemoveActor(actor);
}

void CascadeLines::show(const Camera& camera, double aspect, const std::vector<Cascade>& cascades) {
  std::vector<Corners> views, windows;
  for (const Cascade& cascade : cascades) {
    views.push_back(viewCorners(camera, aspect, cascade.nearDistance, cascade.farDistance));
    windows.push_back(windowCorners(cascade.frame));
  }
  setBoxes(*viewData_, views);
  setBoxes(*windowData_, windows);
  for (vtkActor* actor : actors()) actor->VisibilityOn();
}

void CascadeLines::hide() {
  for (vtkActor* actor : actors()) actor->VisibilityOff();
}

}  // namespace umbra
