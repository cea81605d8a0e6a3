#include "datasets/scenes/SceneCatalogue.h"

#include "datasets/scenes/InstalledModels.h"
#include "datasets/scenes/Scenes.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using scenes::SceneEntry;

std::vector<SceneEntry> allScenes() {
  return {scenes::treeBench(), scenes::threePlanes(), scenes::twoPlanes(),
          scenes::spheres(),   scenes::fence(),       scenes::windmill(),
          scenes::car(),       scenes::foliage(),     scenes::teapotArcade()};
}

[[noreturn]] void refuse(const std::string& message) {
  throw Error(ErrorKind::BadInput, message);
}

SceneEntry entryNamed(const std::string& name) {
  std::vector<std::string> names;
  for (SceneEntry& entry : allScenes()) {
    if (entry.info.name == name) return entry;
    names.push_back(entry.info.name);
  }
  for (const SceneInfo& model : installedModelInfos()) names.push_back(model.name);
  const std::string nearest = nearestWord(name, names);
  refuse("there is no scene '" + clipped(name) + "'" +
         (nearest.empty() ? "; there are " + joined(names) : "; did you mean '" + nearest + "'?"));
}

// Every parameter of the scene, as given or its default.
scenes::Values valuesFor(const SceneInfo& info, const std::map<std::string, double>& given) {
  scenes::Values values;
  std::vector<std::string> names;
  for (const SceneParameter& parameter : info.parameters) {
    values[parameter.name] = parameter.value;
    names.push_back(parameter.name);
    const auto found = given.find(parameter.name);
    if (found == given.end()) continue;
    // The comparison is written so that a NaN fails, too.
    if (!(found->second >= parameter.low && found->second <= parameter.high))
      refuse("scene " + info.name + ": " + parameter.name + ": " + shortNumber(found->second) +
             " is not right, it takes a number from " + shortNumber(parameter.low) + " to " +
             shortNumber(parameter.high));
    values[parameter.name] = found->second;
  }
  for (const auto& [name, value] : given)
    if (!values.contains(name))
      refuse("scene " + info.name + ": there is no parameter '" + name + "'; " +
             (names.empty() ? "this scene has none" : "there are " + joined(names)));
  return values;
}

}  // namespace

std::vector<SceneInfo> sceneCatalogue() {
  std::vector<SceneInfo> infos;
  for (SceneEntry& entry : allScenes()) infos.push_back(std::move(entry.info));
  for (SceneInfo& model : installedModelInfos()) infos.push_back(std::move(model));
  return infos;
}

void checkScene(const std::string& name, const std::map<std::string, double>& parameters) {
  if (!isInstalledModel(name)) return void(valuesFor(entryNamed(name).info, parameters));
  if (!parameters.empty())
    refuse("scene " + name + ": there is no parameter '" + parameters.begin()->first +
           "'; this scene has none");
}

Scene makeScene(const std::string& name, const std::map<std::string, double>& parameters) {
  if (isInstalledModel(name)) {
    checkScene(name, parameters);
    return makeInstalledModel(name);
  }
  const SceneEntry entry = entryNamed(name);
  const scenes::Values values = valuesFor(entry.info, parameters);
  Scene scene = entry.build(values);
  scene.name = entry.info.name;
  scene.title = entry.info.title;
  scene.description = entry.info.description;
  scene.figure = entry.info.figure;
  return scene;
}

std::vector<double> planeDepthsOf(const std::string& name,
                                  const std::map<std::string, double>& parameters) {
  std::vector<double> depths;
  for (const SceneEntry& entry : allScenes()) {
    if (entry.info.name != name || entry.info.planes.empty()) continue;
    const scenes::Values values = valuesFor(entry.info, parameters);
    for (const std::string& plane : entry.info.planes) depths.push_back(values.at(plane));
  }
  return depths;
}

}  // namespace umbra
