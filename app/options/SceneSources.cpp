#include "app/options/SceneSources.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "app/options/OptionValues.h"
#include "app/output/TerminalProgress.h"
#include "datasets/meshes/MeshFileReader.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "datasets/session/LoadSource.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/support/Text.h"

namespace umbra {

namespace fs = std::filesystem;

namespace {

std::string nearestScene(const std::string& name) {
  std::vector<std::string> names;
  for (const SceneInfo& info : sceneCatalogue()) names.push_back(info.name);
  const std::string nearest = nearestWord(name, names);
  return nearest.empty() ? "`umbrascope scenes` lists them" : "did you mean '" + nearest + "'?";
}

}  // namespace

SceneSource sceneSourceFrom(const std::string& name, std::string_view where) {
  SceneSource source;
  source.name = name;
  const std::vector<SceneInfo> scenes = sceneCatalogue();
  if (std::any_of(scenes.begin(), scenes.end(), [&](const auto& s) { return s.name == name; }))
    return source;
  source.kind = SourceKind::MeshFile;
  if (meshfile::isMeshName(name)) {
    checkInput(name);
    return source;
  }
  throw Error(ErrorKind::BadCommandLine,
              std::string(where) + ": '" + name + "' is neither a scene nor a mesh file (" +
                  meshfile::meshExtensions() + "); " + nearestScene(name));
}

void adjustScene(SceneSource& source, const std::string& setting) {
  const std::string option = "--scene-set";
  const auto [name, text] = assignmentFrom(setting, option);
  if (source.kind != SourceKind::Catalogue)
    throw Error(ErrorKind::BadCommandLine, option + ": only goes with a scene of the catalogue");
  std::vector<std::string> names;
  for (const SceneInfo& info : sceneCatalogue()) {
    if (info.name != source.name) continue;
    for (const SceneParameter& parameter : info.parameters) {
      if (parameter.name == name) {
        source.parameters[name] =
            numberFrom(text, option + " " + name, {parameter.low, parameter.high});
        return;
      }
      names.push_back(parameter.name);
    }
  }
  throw Error(ErrorKind::BadCommandLine,
              option + ": scene '" + source.name + "' has no parameter '" + name + "'" +
                  (names.empty() ? ", nor any other" : "; it has " + joined(names)));
}

std::shared_ptr<const Scene> SceneLoader::scene(const SceneSource& source) {
  if (source.kind == SourceKind::DepthFile)
    throw Error(ErrorKind::BadCommandLine,
                "--depth: a depth map has no scene to draw, give --scene NAME|FILE");
  for (const auto& [known, scene] : loaded_)
    if (known == source) return scene;
  const Content content = loadSource(source, progressOnTerminal(shortNameOf(source)));
  for (const std::string& notice : content.notices) spdlog::warn("{}", notice);
  loaded_.emplace_back(source, content.scene);
  return content.scene;
}

DepthFile loadedDepth(const SceneSource& source) {
  DepthFile file = loadDepth(source);
  for (const std::string& note : file.notes) spdlog::warn("{}", note);
  return file;
}

double receiverFrom(std::string_view text, std::string_view option, const DepthFile& file, int x,
                    int y) {
  const std::optional<GivenDepth> given = givenDepthFrom(text);
  if (!given)
    throw Error(
        ErrorKind::BadCommandLine,
        std::string(option) + ": '" + clipped(text) +
            "' is not right, it takes a linear depth from 0 to 1, a distance such as 6w, or "
            "a value of the file such as 0.97f");
  const double depth = linearOf(*given, file.scale, x, y);
  if (!(depth >= 0.0 && depth <= 1.0))
    throw Error(ErrorKind::BadCommandLine,
                std::string(option) + ": '" + clipped(text) + "' is linear depth " +
                    toText(ParameterValue(depth)) + ", it takes one from 0 to 1, or from " +
                    toText(ParameterValue(file.scale.near())) + "w to " +
                    toText(ParameterValue(file.scale.far())) + "w");
  return depth;
}

std::string shortNameOf(const SceneSource& source) {
  return source.kind == SourceKind::Catalogue ? source.name
                                              : fs::path(source.name).filename().string();
}

}  // namespace umbra
