// One function for each scene of the catalogue, in the order of the list.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "datasets/scenes/MeshBuilder.h"
#include "datasets/scenes/SceneCatalogue.h"

namespace umbra::scenes {

// All parameters of a scene by name, each within its range.
using Values = std::map<std::string, double>;

struct SceneEntry {
  SceneInfo info;
  // Fills objects, light and camera; the catalogue adds the texts of `info`.
  std::function<Scene(const Values&)> build;
};

SceneEntry treeBench();
SceneEntry threePlanes();
SceneEntry twoPlanes();
SceneEntry spheres();
SceneEntry fence();
SceneEntry windmill();
SceneEntry car();
SceneEntry foliage();
SceneEntry teapotArcade();

// Helpers that several scenes use.
Light sun(const Vector3d& position, const Vector3d& target = Vector3d::Zero());
Camera lookFrom(const Vector3d& position, const Vector3d& target, double viewAngle = 30.0);
// A paved square that catches the scene's shadows and bounds the light's frame, set into a hole of
// a wide ground that does not bound it. The top of either is at or just below y = 0. No ground that
// is turned to a light 20° or more above the horizon lies under the paving, where it would receive
// shadow that nobody sees.
void addGround(Scene& scene, const Vector3d& centre, double halfX, double halfZ,
               const Vector3d& paving, const Vector3d& surroundings);
SceneObject object(std::string name, Mesh mesh, const Vector3d& colour);

// Muted sRGB colours that sit well beside each other.
namespace colours {
inline const Vector3d paper{0.87, 0.85, 0.81}, sand{0.80, 0.75, 0.66}, stone{0.66, 0.65, 0.63},
    slate{0.45, 0.50, 0.55}, lawn{0.62, 0.67, 0.54}, leaf{0.43, 0.55, 0.34},
    darkLeaf{0.33, 0.45, 0.30}, bark{0.46, 0.37, 0.30}, wood{0.72, 0.56, 0.41},
    brick{0.70, 0.44, 0.36}, rose{0.76, 0.55, 0.52}, ochre{0.80, 0.65, 0.40},
    teal{0.36, 0.55, 0.57}, blue{0.43, 0.54, 0.68}, iron{0.30, 0.32, 0.34}, white{0.92, 0.91, 0.89};
}  // namespace colours

}  // namespace umbra::scenes
