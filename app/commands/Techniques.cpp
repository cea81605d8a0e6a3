#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/commands/Commands.h"
#include "app/output/Table.h"
#include "app/reports/Reports.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/core/technique/TechniquePage.h"

namespace umbra {
namespace {

void printTable(const std::vector<std::unique_ptr<Technique>>& techniques) {
  std::vector<TableRow> rows{{"NAME", "TITLE", "AFTER", "STORES"}};
  std::vector<TableRow> parameters{{"PARAMETER", "SYMBOL", "UNIT", "RANGE", "DEFAULT", "MEANING"}};
  for (const auto& technique : techniques) {
    const TechniqueInfo& info = technique->info();
    rows.push_back({std::string(info.id), std::string(info.title), std::string(info.citation),
                    std::string(info.summary)});
    for (const Parameter& p : technique->parameters())
      parameters.push_back({std::string(info.id) + "." + std::string(p.name), std::string(p.symbol),
                            std::string(p.unit), rangeText(p), toText(p.defaultValue),
                            std::string(p.doc)});
  }
  print(tableText(rows) + "\n" + tableText(parameters));
}

void listTechniques(bool json) {
  const TechniqueCatalogue catalogue = allTechniques();
  std::vector<std::unique_ptr<Technique>> techniques;
  for (const Technique* technique : catalogue.all()) techniques.push_back(technique->clone());
  if (!json) return printTable(techniques);
  Json list = Json::array();
  for (const auto& technique : techniques) list.push_back(techniqueToJson(*technique));
  printJson({{"techniques", list}});
}

void printPage(const std::string& id) {
  print(pageOf(*allTechniques().make(id, "techniques")));
}

}  // namespace

Command addTechniques(OptionParser& program) {
  OptionParser command =
      program.addCommand("techniques", "List the techniques and their parameters", commandsGroup);
  const auto json = std::make_shared<bool>(false);
  command.addFlag("--json", *json, {.text = "Print one JSON object"});
  const auto name = std::make_shared<std::optional<std::string>>();
  command.addArgument("name", *name,
                      {.takes = "NAME", .text = "Print this technique's page, Markdown"}, "--json");
  return {command, [json, name] { *name ? printPage(**name) : listTechniques(*json); }};
}

}  // namespace umbra
