#include "filters/core/Scene.h"

namespace umbra {

Eigen::AlignedBox3d Mesh::bounds() const {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& position : positions) box.extend(position.cast<double>());
  return box;
}

Eigen::AlignedBox3d Scene::bounds() const {
  Eigen::AlignedBox3d box;
  for (const SceneObject& object : objects) box.extend(object.mesh.bounds());
  return box;
}

Eigen::AlignedBox3d Scene::lightBounds() const {
  Eigen::AlignedBox3d box;
  for (const SceneObject& object : objects)
    if (object.boundsLight) box.extend(object.mesh.bounds());
  return box.isEmpty() ? bounds() : box;
}

std::size_t Scene::triangleCount() const {
  std::size_t count = 0;
  for (const SceneObject& object : objects) count += object.mesh.triangles.size();
  return count;
}

}  // namespace umbra
