#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/Commands.h"
#include "app/output/Table.h"
#include "app/reports/Reports.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

void printTable(const std::vector<SceneInfo>& scenes) {
  std::vector<TableRow> rows{{"NAME", "TITLE", "STANDS FOR"}};
  std::vector<TableRow> parameters{{"PARAMETER", "OF", "RANGE", "DEFAULT", "MEANING"}};
  std::string missing;
  for (const SceneInfo& scene : scenes) {
    rows.push_back({scene.name, scene.title, scene.figure});
    for (const SceneParameter& p : scene.parameters)
      parameters.push_back({p.name, scene.name, shortNumber(p.low) + " … " + shortNumber(p.high),
                            shortNumber(p.value), p.doc});
    if (!scene.missing.empty()) missing += scene.name + ": " + scene.missing + "\n";
  }
  std::string text = tableText(rows);
  if (parameters.size() > 1) text += "\n" + tableText(parameters);
  if (!missing.empty()) text += "\nNot installed here:\n" + missing;
  print(text);
}

void listScenes(bool json) {
  const std::vector<SceneInfo> scenes = sceneCatalogue();
  if (!json) return printTable(scenes);
  Json list = Json::array();
  for (const SceneInfo& scene : scenes) list.push_back(sceneToJson(scene));
  printJson({{"scenes", list}});
}

}  // namespace

Command addScenes(OptionParser& program) {
  OptionParser command =
      program.addCommand("scenes", "List the scenes of the catalogue", commandsGroup);
  const auto json = std::make_shared<bool>(false);
  command.addFlag("--json", *json, {.text = "Print one JSON object"});
  return {command, [json] { listScenes(*json); }};
}

}  // namespace umbra
