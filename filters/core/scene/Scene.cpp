#include "filters/core/scene/Scene.h"

#include "filters/core/support/Error.h"

namespace umbra {

bool looksAlongUp(const Camera& camera) {
  const Eigen::Vector3d direction = (camera.target - camera.position).normalized();
  return !(direction.cross(camera.up.normalized()).norm() >= 1e-6);
}

void validate(const Camera& camera, std::string_view where) {
  detail::validateLine(camera.position, camera.target, where);
  for (double part : camera.up)
    detail::validateNumber(part, -largestCoordinate, largestCoordinate, where, "the up vector");
  const auto refuse = [where](const std::string& what) {
    throw Error(ErrorKind::BadInput, std::string(where) + ": the up vector " + what);
  };
  if (!(camera.up.norm() > 0.0)) refuse("has no length, it should point up");
  if (looksAlongUp(camera)) refuse("lies along the view, it should point to its side");
  detail::validateNumber(camera.viewAngle, Camera::smallestViewAngle, Camera::largestViewAngle,
                         where, "the view angle");
}

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
