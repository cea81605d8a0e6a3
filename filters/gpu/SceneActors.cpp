#include "filters/gpu/SceneActors.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cstring>

#include "filters/core/scene/ClosedBody.h"

namespace umbra {
namespace {

vtkSmartPointer<vtkFloatArray> toArray(const std::vector<Eigen::Vector3f>& vectors) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(vtkIdType(vectors.size()));
  if (!vectors.empty())
    std::memcpy(array->GetPointer(0), vectors.data(), vectors.size() * sizeof(Eigen::Vector3f));
  return array;
}

vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(toArray(mesh.positions));
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& triangle : mesh.triangles) {
    const vtkIdType ids[] = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, ids);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  if (mesh.normals.size() == mesh.positions.size() && !mesh.normals.empty()) {
    const auto normals = toArray(mesh.normals);
    normals->SetName("Normals");
    data->GetPointData()->SetNormals(normals);
  }
  return data;
}

vtkSmartPointer<vtkActor> toActor(vtkPolyData* data) {
  const auto mapper = vtkSmartPointer<vtkOpenGLPolyDataMapper>::New();
  mapper->SetInputData(data);
  // The shaders take the caster's vertices as world coordinates.
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void setMaterial(vtkProperty& property, const Material& material) {
  property.SetColor(material.colour.x(), material.colour.y(), material.colour.z());
  if (material.physicallyBased) {
    property.SetInterpolationToPBR();
    property.SetRoughness(material.roughness);
    property.SetMetallic(material.metallic);
  } else {
    property.SetInterpolationToPhong();
    property.SetAmbient(0.0);
    property.SetDiffuse(1.0);
    property.SetSpecular(material.specular);
    property.SetSpecularPower(material.shininess);
  }
}

Mesh mergedPositions(const Scene& scene) {
  Mesh merged;
  for (const SceneObject& object : scene.objects) {
    const auto offset = std::uint32_t(merged.positions.size());
    merged.positions.insert(merged.positions.end(), object.mesh.positions.begin(),
                            object.mesh.positions.end());
    for (const auto& [a, b, c] : object.mesh.triangles)
      merged.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return merged;
}

}  // namespace

void SceneActors::setScene(const Scene& scene, vtkRenderer& renderer) {
  removeFrom(renderer);
  for (const SceneObject& object : scene.objects) {
    if (object.mesh.triangles.empty()) continue;
    const auto actor = toActor(toPolyData(object.mesh));
    setMaterial(*actor->GetProperty(), object.material);
    renderer.AddActor(actor);
    objects_.push_back(actor);
    if (isClosedBody(object.mesh)) closedBodies_.push_back(actor);
  }
  caster_ = toActor(toPolyData(mergedPositions(scene)));
  caster_->GetProperty()->LightingOff();
}

void SceneActors::removeFrom(vtkRenderer& renderer) {
  for (const auto& actor : objects_) renderer.RemoveActor(actor);
  objects_.clear();
  closedBodies_.clear();
  // The caster is not in the renderer, which would have told it to free its buffers.
  if (caster_ && renderer.GetRenderWindow())
    caster_->ReleaseGraphicsResources(renderer.GetVTKWindow());
  caster_ = nullptr;
}

SceneLights::SceneLights(vtkRenderer& renderer)
    : casting_(vtkSmartPointer<vtkLight>::New()), fill_(vtkSmartPointer<vtkLight>::New()) {
  casting_->SetLightTypeToSceneLight();
  fill_->SetLightTypeToCameraLight();
  fill_->SetPosition(0.0, 1.0, 1.0);
  fill_->SetIntensity(0.42);
  renderer.AutomaticLightCreationOff();
  for (vtkLight* light : {casting_.Get(), fill_.Get()}) renderer.AddLight(light);
}

void SceneLights::setLight(const Light& light) {
  casting_->SetPosition(light.position.x(), light.position.y(), light.position.z());
  casting_->SetFocalPoint(light.target.x(), light.target.y(), light.target.z());
  casting_->SetColor(light.colour.x(), light.colour.y(), light.colour.z());
  // The dim light's share leaves room for the casting light below white.
  casting_->SetIntensity(0.75 * light.intensity);
  casting_->SetPositional(light.kind == LightKind::Spot);
  casting_->SetConeAngle(light.halfAngle);  // VTK's cone angle is the half angle, too
}

}  // namespace umbra
