#include "datasets/scenes/ModelStage.h"

#include <cmath>
#include <numbers>

#include "datasets/scenes/Scenes.h"

namespace umbra {
namespace {

using Eigen::Vector3d;

// The direction that points `right` degrees from +z and `up` degrees above the horizon.
Vector3d towards(double right, double up) {
  const double a = right * std::numbers::pi / 180.0, b = up * std::numbers::pi / 180.0;
  return {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
}

Eigen::AlignedBox3d boundsOf(const meshfile::RawMesh& raw, const std::vector<ModelPart>& parts,
                             const Eigen::Affine3d& turned) {
  Eigen::AlignedBox3d box;
  for (const ModelPart& part : parts)
    for (const meshfile::Triangle& t : part.triangles)
      for (std::uint32_t v : t) box.extend(turned * raw.positions[v]);
  return box;
}

// Turns +z to +y, and +y to −z.
Eigen::Affine3d raised() {
  Eigen::Affine3d turn = Eigen::Affine3d::Identity();
  turn.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return turn;
}

}  // namespace

Scene stagedScene(const meshfile::RawMesh& raw, const std::vector<ModelPart>& parts,
                  const ModelStage& stage, const Progress& progress) {
  Eigen::Affine3d turned = scenes::turned(stage.turn);
  if (stage.zIsUp) turned = turned * raised();
  const Eigen::AlignedBox3d box = boundsOf(raw, parts, turned);
  const double longest = box.sizes().maxCoeff(), scale = longest > 0.0 ? stage.size / longest : 1.0;
  const Vector3d foot(box.center().x(), box.min().y(), box.center().z());
  const Eigen::Affine3d placement =
      Eigen::Affine3d(Eigen::Scaling(scale)) * Eigen::Translation3d(-foot) * turned;
  Scene scene;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const ModelPart& part = parts[p];
    const double count = double(parts.size());
    SceneObject object;
    object.name = part.name;
    object.material = part.material;
    object.mesh = meshfile::placedMesh(raw, part.triangles, placement,
                                       progress.stage(double(p) / count, double(p + 1) / count));
    scene.objects.push_back(std::move(object));
  }

  // The ground reaches as far as the shadow, so that the light's frame holds it.
  const Vector3d half = 0.5 * scale * box.sizes(), sun = towards(stage.sunFrom, stage.sunUp);
  const Vector3d reach =
      -2.0 * half.y() * sun / std::max(sun.y(), 0.2);  // of the shadow of the model's top
  const double margin = 0.35;
  const Vector3d shadow(0.5 * reach.x(), 0.0, 0.5 * reach.z());
  scenes::addGround(scene, shadow, half.x() + 0.5 * std::abs(reach.x()) + margin,
                    half.z() + 0.5 * std::abs(reach.z()) + margin, scenes::colours::sand,
                    scenes::colours::stone);
  const Vector3d target(0.35 * shadow.x(), 0.85 * half.y(), 0.35 * shadow.z());
  scene.light = scenes::sun(target + 10.0 * sun, target);

  // A sphere around the model and half of its shadow almost fills the view; its corners stay empty.
  const double viewAngle = 30.0;
  const double radius = (half + 0.25 * reach.cwiseAbs()).norm();
  const double distance = 0.72 * radius / std::sin(0.5 * viewAngle * std::numbers::pi / 180.0);
  scene.camera = scenes::lookFrom(target + distance * towards(stage.viewFrom, stage.viewUp), target,
                                  viewAngle);
  return scene;
}

}  // namespace umbra
