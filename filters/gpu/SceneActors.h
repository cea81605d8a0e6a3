// A scene as VTK draws it: one actor per object, one merged caster for the light, the lights.
#pragma once

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"

class vtkRenderer;

namespace umbra {

class SceneActors {
 public:
  // Replaces the objects of the last scene in `renderer` by those of `scene`.
  void setScene(const Scene& scene, vtkRenderer& renderer);
  void removeFrom(vtkRenderer& renderer);

  const std::vector<vtkSmartPointer<vtkActor>>& objects() const { return objects_; }
  // The objects that bound solid bodies: from outside, their back faces cannot be seen.
  const std::vector<vtkSmartPointer<vtkActor>>& closedBodies() const { return closedBodies_; }
  // Everything that casts a shadow, as one mesh of positions, so that the light draws it at once.
  // It is not in the renderer, so that the camera's culling cannot remove it.
  vtkActor* caster() const { return caster_; }

 private:
  std::vector<vtkSmartPointer<vtkActor>> objects_, closedBodies_;
  vtkSmartPointer<vtkActor> caster_;
};

// The casting light, which is light 0 in VTK's shaders, and a dim light above the camera that casts
// no shadow, so that shapes can be told apart in the shadow. There is only one dim light: beside a
// spot light, VTK treats all lights as spots, and each costs as much as a shadow.
class SceneLights {
 public:
  explicit SceneLights(vtkRenderer& renderer);
  void setLight(const Light& light);

 private:
  vtkSmartPointer<vtkLight> casting_, fill_;
};

}  // namespace umbra
