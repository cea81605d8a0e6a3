#include "datasets/scenes/MeshScene.h"

#include "datasets/scenes/ModelStage.h"

namespace umbra {

Scene sceneFromMeshFile(const std::filesystem::path& file, MeshReport* report) {
  SceneObject object;
  object.name = file.stem().string();
  object.mesh = readMeshFile(file, report);
  object.material.colour = {0.62, 0.66, 0.70};
  Scene scene = stagedScene({std::move(object)}, {});
  scene.name = file.stem().string();
  scene.title = file.filename().string();
  scene.description = "A mesh file on a ground plane, scaled to about four units.";
  return scene;
}

}  // namespace umbra
