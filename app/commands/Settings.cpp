#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/Commands.h"
#include "app/output/Table.h"
#include "app/reports/Reports.h"
#include "datasets/session/SessionSettings.h"
#include "datasets/session/file/SessionFileSettings.h"
#include "datasets/session/file/SessionSchema.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

struct SettingsCommand {
  bool json = false, schema = false;

  void run() const;
};

Json rangeJson(const SettingInfo& info) {
  if (!info.values.empty()) return info.values;
  if (rangeText(info).empty() || info.kind == SettingKind::Choice) return nullptr;
  return {info.low, info.high};
}

Json settingJson(const Setting& setting) {
  const SettingInfo& info = setting.info;
  Json json{{"name", info.name}, {"key", info.key}};
  if (!info.option.empty()) json["option"] = info.option;
  json["symbol"] = info.symbol;
  json["unit"] = info.unit;
  json["range"] = rangeJson(info);
  json["default"] = toJson(info, setting.defaultValue);
  if (!info.automatic.empty()) json["automatic"] = info.automatic;
  json["choices"] = info.choices;
  json["doc"] = info.doc;
  json["stage"] = nameOf(info.stage);
  json["pane"] = info.pane.has_value();
  return json;
}

void printTable(const std::vector<Setting>& settings) {
  std::vector<TableRow> rows{{"NAME", "SYMBOL", "RANGE", "DEFAULT", "STAGE", "MEANING"}};
  for (const Setting& setting : settings) {
    const SettingInfo& info = setting.info;
    rows.push_back({std::string(info.name), std::string(info.symbol), rangeText(info),
                    defaultText(info, setting.defaultValue), std::string(nameOf(info.stage)),
                    std::string(info.doc)});
  }
  print(tableText(rows));
}

void SettingsCommand::run() const {
  if (json && schema)
    throw Error(ErrorKind::BadCommandLine, "--schema: excludes --json, give one of them");
  if (schema) return printJson(sessionSchema());
  Session defaults;
  const std::vector<Setting> settings = settingsOf(defaults);
  if (!json) return printTable(settings);
  Json list = Json::array();
  for (const Setting& setting : settings) list.push_back(settingJson(setting));
  printJson({{"settings", list}});
}

}  // namespace

Command addSettings(OptionParser& program) {
  OptionParser command = program.addCommand(
      "settings", "List the settings of a session, or its schema", commandsGroup);
  const auto settings = std::make_shared<SettingsCommand>();
  command.addFlag("--json", settings->json, {.text = "Print one JSON object"});
  command.addFlag("--schema", settings->schema,
                  {.text = "Print the JSON schema of a session's file"});
  command.setFooter(
      "A setting's name is that of an axis of a sweep; its stage is the first that is done again\n"
      "when it changes. Techniques' own parameters: `umbrascope techniques`.");
  return {command, [settings] { settings->run(); }};
}

}  // namespace umbra
