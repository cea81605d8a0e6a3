#include "app/options/SessionOptions.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "app/options/OptionValues.h"
#include "datasets/maps/DepthFile.h"
#include "datasets/maps/Raster.h"
#include "datasets/meshes/MeshFileReader.h"
#include "datasets/session/PaneChoice.h"
#include "datasets/session/SessionSettings.h"
#include "datasets/session/file/SessionFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// However the path of a file is written.
bool sameSource(SceneSource a, SceneSource b) {
  for (SceneSource* source : {&a, &b}) {
    if (source->kind == SourceKind::Catalogue) continue;
    std::error_code unreadable;  // leaves the name as it is
    const auto path = std::filesystem::weakly_canonical(source->name, unreadable);
    if (!unreadable) source->name = path.string();
  }
  return a == b;
}

// Writes "The kernel has (2r+1)² taps (0 to 64 texels; default 3)".
std::string helpText(const Setting& setting) {
  const SettingInfo& info = setting.info;
  const std::string range = rangeText(info);
  return std::string(info.doc) + " (" + range + (range.empty() ? "" : "; ") + "default " +
         (isOfScene(info) ? "the scene's" : defaultText(info, setting.defaultValue)) + ")";
}

}  // namespace

void SessionOptions::addTo(OptionParser& command) {
  addInput(command);
  addTechnique(command);
  addSettings(command, "Technique and prefilter");
  addSettings(command, "Shadow map");
  addSettings(command, "Read of the shaded frame");
  addView(command);
}

void SessionOptions::addInput(OptionParser& command) {
  const char* group = "Input";
  command.add("--scene", scene_,
              {group, "NAME|FILE",
               "Scene of the catalogue, or mesh file (" + meshfile::meshExtensions() + ")"});
  command.addRepeatable("--scene-set", sceneSettings_,
                        {group, "PARAMETER=VALUE", "Adjust the scene, see `scenes`; repeatable"});
  command.add("--up", up_, {group, "y|z", "Which axis of the mesh file points up (default y)"});
  command.add("--depth", depth_,
              {group, "FILE[:CHANNEL]",
               "Depth map instead of a scene (" + rasterExtensions() +
                   "); of an OpenEXR file by default the channel Z, else the only one"});
  command.add("--depth-range", depthRange_,
              {group, "NEAR,FAR",
               "Values that become 0 and 1 (default 0,1; NEAR may be the larger: reversed)"});
  command.add(
      "--depth-projection", depthProjection_,
      {group, "PROJECTION",
       "What drew the map, to be undone: " + std::string(projectionSyntax) + " (default linear)"});
  command.add("--depth-miss", depthMiss_,
              {group, "error|clamp|VALUE",
               "What becomes of values that are no depths: an error, the nearest bound, or VALUE. "
               "A VALUE beyond the range, or the near bound, is what texels hold that saw nothing; "
               "these become the far bound (default error)"});
  command.add(
      "--session", session_,
      {group, "FILE",
       "Start from a saved session (.json), or from that of an .exr that `render` or `encode` "
       "wrote; options override it"});
}

void SessionOptions::addTechnique(OptionParser& command) {
  const char* group = "Technique and prefilter";
  command.add("--technique", techniques_,
              {group, "A[,B...]|all", "One or more techniques, see `techniques`"});
  command.addRepeatable("--set", settings_,
                        {group, "TECHNIQUE.PARAMETER=VALUE",
                         "Set a technique's parameter, see `techniques`; repeatable"});
}

void SessionOptions::addView(OptionParser& command) {
  const char* group = "View";
  command.add(
      "--light", light_,
      {group, "LIGHT",
       "Casting light, world; left out parts stay the scene's: " + std::string(lightSyntax)});
  command.add("--camera", camera_,
              {group, "CAMERA", "Camera, world, angle in degrees: " + std::string(cameraSyntax)});
  addSettings(command, group);
}

void SessionOptions::addSettings(OptionParser& command, std::string_view group) {
  Session defaults;
  for (const Setting& setting : settingsOf(defaults)) {
    const SettingInfo& info = setting.info;
    // A row that takes no word by itself is set together with others.
    if (info.group != group || info.takes.empty()) continue;
    OfTable& option = table_.emplace_back(OfTable{info, {}});
    command.add(std::string(info.option), option.text,
                {group, std::string(info.takes), helpText(setting)});
  }
}

bool SessionOptions::namesFormat() const {
  return std::any_of(table_.begin(), table_.end(), [](const OfTable& option) {
    return option.text && option.info.name == "map.format";
  });
}

Workspace SessionOptions::workspace(const TechniqueCatalogue& catalogue) const {
  Workspace start;
  if (session_) refuseEmpty(*session_, "--session", "FILE");
  if (session_) start = readWorkspace(*session_);
  return over(std::move(start), catalogue);
}

Session SessionOptions::session(const TechniqueCatalogue& catalogue) const {
  return sessionOf(workspace(catalogue));
}

Workspace SessionOptions::over(Workspace base, const TechniqueCatalogue& catalogue) const {
  editSource(base.shared);
  editTechnique(base, catalogue);
  editSession(base, [&](Session& active) {
    editParameters(active, catalogue);
    editView(active);
  });
  return base;
}

void SessionOptions::editSource(Session& session) const {
  if (scene_ && depth_)
    throw Error(ErrorKind::BadCommandLine, "--depth: excludes --scene, give one of them");
  if (scene_) refuseEmpty(*scene_, "--scene", "NAME or FILE");
  if (depth_) refuseEmpty(*depth_, "--depth", "FILE[:CHANNEL]");
  const SceneSource former = session.source;
  if (scene_) session.source = sceneSourceFrom(*scene_, "--scene");
  if (depth_) {
    session.source = {};
    session.source.kind = SourceKind::DepthFile;
    std::tie(session.source.name, session.source.depth.channel) = splitDepthArgument(*depth_);
  }
  editDepth(session.source);
  if (up_) {
    if (session.source.kind != SourceKind::MeshFile)
      throw Error(ErrorKind::BadCommandLine, "--up: only goes with a mesh file");
    asOption([&] { session.source.up = upAxisFrom(*up_, "--up"); });
  }
  for (const std::string& setting : sceneSettings_) adjustScene(session.source, setting);
  if ((scene_ || depth_) && !sameSource(session.source, former)) {  // places of another one
    session.probes.clear();
    session.keptProbe.clear();
  }
}

void SessionOptions::editDepth(SceneSource& source) const {
  const auto given = [&](const Text& text, const char* option) {
    if (text && source.kind != SourceKind::DepthFile)
      throw Error(ErrorKind::BadCommandLine, std::string(option) + ": only goes with --depth");
    return text.has_value();
  };
  if (given(depthRange_, "--depth-range"))
    std::tie(source.depth.atZero, source.depth.atOne) =
        depthRangeFrom(*depthRange_, "--depth-range");
  asOption([&] {
    if (given(depthProjection_, "--depth-projection"))
      source.depth.projection = projectionFrom(*depthProjection_, "--depth-projection");
    if (given(depthMiss_, "--depth-miss"))
      source.depth.miss = depthMissFrom(*depthMiss_, "--depth-miss");
  });
}

std::vector<std::string> idsOf(const TechniqueCatalogue& catalogue) {
  std::vector<std::string> ids;
  for (const Technique* technique : catalogue.all()) ids.emplace_back(technique->info().id);
  return ids;
}

TechniqueChoice everyTechnique(const TechniqueCatalogue& catalogue) {
  return {idsOf(catalogue), true};
}

TechniqueChoice SessionOptions::techniques(const TechniqueCatalogue& catalogue,
                                           const TechniqueChoice& fallback) const {
  if (!techniques_) return fallback;
  const std::vector<std::string> named = split(*techniques_, ',');
  const bool all = std::find(named.begin(), named.end(), "all") != named.end();
  std::vector<std::string> ids;
  for (const std::string& id : named) {
    if (id != "all" && !catalogue.has(id)) {
      const std::vector<std::string> known = idsOf(catalogue);
      const std::string nearest = nearestWord(id, known);
      throw Error(ErrorKind::BadCommandLine,
                  "--technique: there is no '" + id + "'; " +
                      (nearest.empty() ? "there are " + joined(known) + " and all"
                                       : "did you mean '" + nearest + "'?"));
    }
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  }
  if (ids.empty())
    throw Error(ErrorKind::BadCommandLine, "--technique: is empty, it takes A[,B...] or all");
  return all ? everyTechnique(catalogue) : TechniqueChoice{ids, false};
}

void SessionOptions::editTechnique(Workspace& workspace,
                                   const TechniqueCatalogue& catalogue) const {
  // One of all is no choice: the session's own stays the one to look at.
  const TechniqueChoice choice = techniques(catalogue, {{workspace.shared.technique}});
  if (!choice.all) chooseTechnique(workspace, choice.ids.front());
}

void SessionOptions::editParameters(Session& session, const TechniqueCatalogue& catalogue) const {
  for (const std::string& setting : settings_) {
    const auto [name, text] = assignmentFrom(setting, "--set");
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos)
      throw Error(ErrorKind::BadCommandLine,
                  "--set: '" + setting + "' is not right, it takes TECHNIQUE.PARAMETER=VALUE");
    const std::string id = name.substr(0, dot), parameter = name.substr(dot + 1);
    try {
      catalogue.make(id, "--set " + name);
      umbra::editParameters(session, catalogue, id,
                            [&, &name = name, &text = text](std::span<const Parameter> parameters) {
                              parameterNamed(parameters, parameter, "--set " + name)
                                  .setFromText(text, "--set " + name);
                            });
    } catch (const Error& error) {
      // The value came from the command line, whatever reads values from files calls it.
      const bool prefixed = std::string_view(error.what()).starts_with("--set");
      throw Error(ErrorKind::BadCommandLine,
                  (prefixed ? "" : "--set: ") + std::string(error.what()));
    }
  }
}

// Returns the first given option that sets a part of light or camera; "" if none does.
std::string SessionOptions::optionOfScene() const {
  if (light_) return "--light";
  if (camera_) return "--camera";
  for (const OfTable& option : table_)
    if (option.text && isOfScene(option.info)) return std::string(option.info.option);
  return {};
}

void SessionOptions::editView(Session& session) const {
  const std::string option = optionOfScene();
  if (option.empty()) return editSettings(session, {}, {});
  if (session.source.kind == SourceKind::DepthFile)
    throw Error(ErrorKind::BadCommandLine, option + ": only goes with a scene");
  const std::shared_ptr<const Scene> scene = this->scene(session.source);
  if (light_) session.light = lightFrom(*light_, "--light", session.light.value_or(scene->light));
  if (camera_)
    session.camera = cameraFrom(*camera_, "--camera", session.camera.value_or(scene->camera));
  editSettings(session, scene->light, scene->camera);
  asOption([&] {
    if (session.light) validate(*session.light, option);
    if (session.camera) validate(*session.camera, option);
  });
}

void SessionOptions::editSettings(Session& session, const Light& light,
                                  const Camera& camera) const {
  const std::vector<Setting> settings = settingsOf(session, light, camera);
  for (const auto& [info, text] : table_)
    if (text)
      asOption([&, &info = info, &text = text] {
        settingNamed(settings, info.name, info.option).setFromText(*text, info.option);
      });
}

}  // namespace umbra
