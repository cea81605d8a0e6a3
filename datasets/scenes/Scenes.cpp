#include "datasets/scenes/Scenes.h"

namespace umbra::scenes {

Light sun(const Vector3d& position, const Vector3d& target) {
  Light light;
  light.kind = LightKind::Directional;
  light.position = position;
  light.target = target;
  light.colour = {1.0, 0.97, 0.92};
  return light;
}

Camera lookFrom(const Vector3d& position, const Vector3d& target, double viewAngle) {
  Camera camera;
  camera.position = position;
  camera.target = target;
  camera.viewAngle = viewAngle;
  return camera;
}

void addGround(Scene& scene, const Vector3d& centre, double halfX, double halfZ,
               const Vector3d& paving, const Vector3d& surroundings) {
  const double thickness = 0.05, horizon = 60.0;
  scene.objects.push_back(object("paving",
                                 box({centre.x() - halfX, -thickness, centre.z() - halfZ},
                                     {centre.x() + halfX, 0.0, centre.z() + halfZ}),
                                 paving));
  SceneObject wide = object("ground",
                            box({centre.x() - horizon, -2.0 * thickness, centre.z() - horizon},
                                {centre.x() + horizon, -0.6 * thickness, centre.z() + horizon}),
                            surroundings);
  wide.boundsLight = false;
  scene.objects.push_back(std::move(wide));
}

SceneObject object(std::string name, Mesh mesh, const Vector3d& colour) {
  SceneObject result;
  result.name = std::move(name);
  result.mesh = std::move(mesh);
  result.material.colour = colour;
  return result;
}

}  // namespace umbra::scenes
