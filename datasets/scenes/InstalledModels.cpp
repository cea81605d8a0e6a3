#include "datasets/scenes/InstalledModels.h"

#include <array>

#include "datasets/meshes/MaterialFile.h"
#include "datasets/meshes/MeshFileReader.h"
#include "datasets/scenes/ArchiveFile.h"
#include "datasets/scenes/ModelStage.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

constexpr const char* collection = "BlendSwap-CC-0.sh3f";
constexpr const char* toInstall = "install the Debian package sweethome3d-furniture";

struct Model {
  const char *name, *entry, *title, *description, *figure;
  ModelStage stage;
};

const std::array<Model, 6>& models() {
  static const std::array<Model, 6> all{
      {{"truck",
        "peterbilt",
        "Truck with a trailer",
        "A long body close to the ground: contact shadows under wheels and chassis,\nwith the "
        "trailer's edge high above them. Look between the wheels.",
        "Gumbau et al. 2011, table 1 (its car)",
        {.size = 6.0, .viewFrom = 48.0, .viewUp = 15.0, .sunFrom = -25.0, .sunUp = 60.0}},
       {"iron-fence",
        "fence",
        "Wrought-iron fence",
        "Bars, rings and scrolls thinner than many a filter, shadows that blur into\none another. "
        "Follow a bar from its foot: the filter's width grows against it.",
        "Annen et al. 2007, fig. 9",
        {.size = 4.5, .viewFrom = 30.0, .viewUp = 24.0, .sunFrom = 160.0, .sunUp = 38.0}},
       {"plant",
        "decorativePlant",
        "Pot plant",
        "Needles over needles over a pot: many depths within one filter region.\nLook at the earth "
        "in the pot and at the pot's own shadow.",
        "",
        {.size = 4.0, .viewFrom = 20.0, .viewUp = 26.0, .sunFrom = -35.0, .sunUp = 58.0}},
       {"fan",
        "tableFan",
        "Table fan",
        "A cage of thin wires before blades before a housing: shadows in one another.\nLook at "
        "the blades, striped by the cage, and at the ground behind the foot.",
        "",
        {.size = 4.0, .viewFrom = 38.0, .viewUp = 18.0, .sunFrom = 55.0, .sunUp = 42.0}},
       {"staircase",
        "spiralStaircase",
        "Spiral staircase",
        "Tread over tread round one pole: each lies in the shadow of those above it.\nLight "
        "bleeds through the lower treads along the edges of the upper ones.",
        "Lauritzen 2008, fig. 4.8 (its overlapping shadows)",
        {.size = 5.0, .viewFrom = 25.0, .viewUp = 24.0, .sunFrom = 60.0, .sunUp = 62.0}},
       {"motorbike",
        "motorbike",
        "Playground motorbike",
        "A closed body on a spring: its coils shadow each other within a filter's\nwidth, and the "
        "handlebar far above them shadows the body.",
        "",
        {.size = 4.0, .viewFrom = 30.0, .viewUp = 20.0, .sunFrom = -20.0, .sunUp = 55.0}}}};
  return all;
}

const Model* modelNamed(const std::string& name) {
  for (const Model& model : models())
    if (model.name == name) return &model;
  return nullptr;
}

// Lifts the linear colours of the model's makers about half of the way to sRGB values. Unchanged
// they are so dark that no shadow can be seen on them.
Eigen::Vector3d lifted(const Eigen::Vector3d& colour) {
  return colour.array().pow(0.65).matrix();
}

// One part for each material, in the order of first use, so that each keeps its own colour.
std::vector<ModelPart> partsOf(const meshfile::RawMesh& raw,
                               const std::map<std::string, Material>& materials) {
  std::vector<ModelPart> parts;
  std::map<std::string, std::size_t> known;
  for (std::size_t t = 0; t < raw.triangles.size(); ++t) {
    const std::string& name = raw.parts[raw.triangleParts[t]].material;
    const auto [found, isNew] = known.try_emplace(name, parts.size());
    if (isNew) parts.push_back({name, {}, {}});
    parts[found->second].triangles.push_back(raw.triangles[t]);
  }
  for (ModelPart& part : parts) {
    const auto material = materials.find(part.name);
    if (material == materials.end()) continue;
    part.material = material->second;
    part.material.colour = lifted(material->second.colour);
  }
  return parts;
}

}  // namespace

fs::path installedModelsFolder() {
  return "/usr/share/sweethome3d/furniture";
}

std::vector<SceneInfo> installedModelInfos(const fs::path& folder) {
  std::error_code problem;
  const bool there = fs::is_regular_file(folder / collection, problem);
  std::vector<SceneInfo> infos;
  for (const Model& model : models())
    infos.push_back({.name = model.name,
                     .title = model.title,
                     .description = model.description,
                     .figure = model.figure,
                     .parameters = {},
                     .missing = there ? "" : toInstall});
  return infos;
}

bool isInstalledModel(const std::string& name) {
  return modelNamed(name) != nullptr;
}

Scene makeInstalledModel(const std::string& name, const fs::path& folder) {
  const Model* model = modelNamed(name);
  if (!model) throw Error(ErrorKind::BadInput, "there is no installed model '" + name + "'");
  const fs::path archive = folder / collection;
  std::error_code problem;
  if (!fs::is_regular_file(archive, problem))
    throw Error(ErrorKind::BadInput, "scene " + name + ": " + toInstall);
  const std::string base = std::string("blendswap-cc-0/") + model->entry + "/" + model->entry;
  const std::vector<std::string> contents = readArchive(archive, {base + ".obj", base + ".mtl"});
  const meshfile::RawMesh raw =
      meshfile::readMesh(contents[0], ".obj", archive.string() + "/" + base + ".obj");
  Scene scene = stagedScene(raw, partsOf(raw, materialsFrom(contents[1])), model->stage);
  scene.name = model->name;
  scene.title = model->title;
  scene.description = model->description;
  scene.figure = model->figure;
  return scene;
}

}  // namespace umbra
