#include "datasets/plans/SweepCell.h"

#include <algorithm>

#include "datasets/json/JsonText.h"
#include "datasets/maps/DepthFile.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "datasets/session/DepthReading.h"
#include "datasets/session/SessionSettings.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view sceneParameter = "scene.";

std::string textAt(const SweepValue& value, const std::string& where, const char* what) {
  if (!value.is_string())
    throw Error(ErrorKind::BadInput, where + ": " + quoted(value) + " should be " + what);
  return value.get<std::string>();
}

// What a cell of the plan sets, one after the other.
class CellSetter {
 public:
  CellSetter(const SweepPlan& plan, const TechniqueCatalogue& catalogue, const SceneOf& sceneOf)
      : plan_(plan), catalogue_(catalogue), sceneOf_(sceneOf), session_(sessionOf(plan.base)) {}

  Session run(const SweepCell& cell, const std::string& where) {
    // A source brings its own light and camera, which later settings change.
    if (std::count_if(cell.begin(), cell.end(),
                      [](const auto& one) { return opensSource(one.first); }) > 1)
      throw Error(
          ErrorKind::BadInput,
          where + ": sets several of 'scene', 'mesh' and 'depth', of which one can be open");
    for (const auto& [setting, value] : cell)
      if (opensSource(setting)) openSource(setting, value, where + ": " + setting);
    for (const auto& [setting, value] : cell)
      if (setting.starts_with(sceneParameter))
        setSceneParameter(setting, value, where + ": " + setting);
    checkSource(where);
    for (const auto& [setting, value] : cell)
      if (!isSource(setting)) set(setting, value, where + ": " + setting);
    if (!plan_.namesFormat) chooseFormatFor(session_);
    return session_;
  }

 private:
  static bool opensSource(const std::string& setting) {
    return setting == "scene" || setting == "mesh" || setting == "depth";
  }
  static bool isSource(const std::string& setting) {
    return opensSource(setting) || setting.starts_with(sceneParameter);
  }

  // The catalogue's own message, behind the place in the plan.
  void checkSource(const std::string& where) const {
    if (session_.source.kind != SourceKind::Catalogue) return;
    try {
      checkScene(session_.source.name, session_.source.parameters);
    } catch (const Error& error) {
      throw Error(ErrorKind::BadInput, where + ": " + error.what());
    }
  }

  void openSource(const std::string& setting, const SweepValue& value, const std::string& where) {
    const std::string name = textAt(value, where, "a name");
    SceneSource source;
    source.name = name;
    if (setting == "mesh") {
      source.kind = SourceKind::MeshFile;
      source.up = session_.source.up;
    } else if (setting == "depth") {
      source.kind = SourceKind::DepthFile;
      // Files of one axis are read alike.
      source.depth = session_.source.depth;
      const auto [file, channel] = splitDepthArgument(name);
      source.name = file;
      if (!channel.empty()) source.depth.channel = channel;
    }
    if (source.kind != SourceKind::Catalogue) {
      source.name = (plan_.folder / source.name).lexically_normal().string();
      if (!fs::exists(source.name))
        throw Error(ErrorKind::BadInput, where + ": there is no file " + source.name);
    }
    session_.source = source;
  }

  void setSceneParameter(const std::string& setting, const SweepValue& value,
                         const std::string& where) {
    if (session_.source.kind != SourceKind::Catalogue)
      throw Error(ErrorKind::BadInput, where + ": only scenes of the catalogue have parameters");
    if (!value.is_number())
      throw Error(ErrorKind::BadInput, where + ": " + quoted(value) + " should be a number");
    session_.source.parameters[setting.substr(sceneParameter.size())] = value.get<double>();
  }

  void set(const std::string& setting, const SweepValue& value, const std::string& where) {
    if (setting == "technique") {
      const std::string id = textAt(value, where, "a technique's name");
      checkTechnique(id, where);
      session_.technique = id;
    } else if (setting == "receiver") {
      if (!value.is_number() || value < 0.0 || value > 1.0)
        throw Error(ErrorKind::BadInput,
                    where + ": " + quoted(value) + " should be a linear depth from 0 to 1");
      session_.receiver = value.get<double>();
    } else if (setting == "probe") {
      if (!value.is_array() || value.size() != 2 || !value[0].is_number_integer() ||
          !value[1].is_number_integer())
        throw Error(ErrorKind::BadInput,
                    where + ": " + quoted(value) + " should be a pixel, [x, y]");
      session_.probe = Pixel{value[0].get<int>(), value[1].get<int>()};
    } else if (!setParameter(setting, value, where)) {
      setRow(setting, value, where);
    }
  }

  // The catalogue takes a wrong name for one of the command line.
  void checkTechnique(const std::string& id, const std::string& where) const {
    try {
      catalogue_.make(id, where);
    } catch (const Error& error) {
      throw Error(ErrorKind::BadInput, error.what());
    }
  }

  // TECHNIQUE.PARAMETER; false where the name begins with no technique.
  bool setParameter(const std::string& setting, const SweepValue& value, const std::string& where) {
    const std::size_t dot = setting.find('.');
    if (dot == std::string::npos) return false;
    const std::string id = setting.substr(0, dot), name = setting.substr(dot + 1);
    if (!catalogue_.has(id)) return false;
    editParameters(session_, catalogue_, id, [&](std::span<const Parameter> parameters) {
      parameterNamed(parameters, name, where).setFromText(textOfValue(value), where);
    });
    return true;
  }

  void setRow(const std::string& setting, const SweepValue& value, const std::string& where) {
    Light light;
    Camera camera;
    const bool hasScene = sceneOf_ && session_.source.kind != SourceKind::DepthFile;
    if (hasScene) {
      const std::shared_ptr<const Scene> scene = sceneOf_(session_.source);
      light = scene->light;
      camera = scene->camera;
    }
    const std::vector<Setting> settings = settingsOf(session_, light, camera);
    const Setting& row = settingNamed(settings, setting, where);
    const bool isSize = row.info.kind == SettingKind::Size && value.is_array() && value.size() == 2;
    row.setFromText(
        isSize ? textOfValue(value[0]) + "x" + textOfValue(value[1]) : textOfValue(value), where);
  }

  const SweepPlan& plan_;
  const TechniqueCatalogue& catalogue_;
  const SceneOf& sceneOf_;
  Session session_;
};

}  // namespace

std::string textOfValue(const SweepValue& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const SweepValue& one : value) text += (text.empty() ? "" : ",") + textOfValue(one);
  return text;
}

Session sessionOfCell(const SweepPlan& plan, std::size_t cell, const TechniqueCatalogue& catalogue,
                      const SceneOf& sceneOf, const std::string& where) {
  return CellSetter(plan, catalogue, sceneOf)
      .run(plan.cells[cell], where + ": cell " + std::to_string(cell));
}

}  // namespace umbra
