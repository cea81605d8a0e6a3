#include "datasets/scenes/Scenes.h"

#include <array>
#include <cmath>
#include <numbers>

#include "datasets/meshes/MeshNormals.h"

namespace umbra::scenes {
namespace {

// A ground around a hole from `low` to `high` in x and z; it extends `reach` from the hole's
// centre. Below its upper edge the hole widens, with walls that have a slope of 19°: they are
// turned away from a light that stands higher, and an object that is set into the hole touches the
// ground only at that edge.
Mesh groundAbout(const Vector2d& low, const Vector2d& high, double reach, double bottom,
                 double top) {
  const double lean = (top - bottom) / std::tan(19.0 * std::numbers::pi / 180.0);
  const Vector2d centre = 0.5 * (low + high), away(reach, reach), aside(lean, lean);
  std::vector<Eigen::Vector3f> points;
  // Counter-clockwise seen from above.
  const auto addRing = [&](const Vector2d& least, const Vector2d& most, double y) {
    for (const Vector3d& point :
         {Vector3d(least.x(), y, most.y()), Vector3d(most.x(), y, most.y()),
          Vector3d(most.x(), y, least.y()), Vector3d(least.x(), y, least.y())})
      points.push_back(point.cast<float>());
  };
  addRing(low, high, top);
  addRing(low - aside, high + aside, bottom);
  addRing(centre - away, centre + away, bottom);
  addRing(centre - away, centre + away, top);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t ring = 0; ring < 4; ++ring)
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t next = (i + 1) % 4, after = 4 * ((ring + 1) % 4), here = 4 * ring;
      triangles.push_back({here + i, after + next, after + i});
      triangles.push_back({here + i, here + next, after + next});
    }
  return withNormals(points, triangles, 10.0);
}

}  // namespace

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
                            groundAbout({centre.x() - halfX, centre.z() - halfZ},
                                        {centre.x() + halfX, centre.z() + halfZ}, horizon,
                                        -2.0 * thickness, -0.6 * thickness),
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
