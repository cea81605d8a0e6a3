#include "app/frames/NamedProbes.h"

#include <nlohmann/json.hpp>

#include "app/output/Table.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

SheetRow sheetRowOf(const NamedResult& result) {
  SheetRow row{result.saved.name, {}, {}, result.reason};
  if (const auto& point = result.saved.point) row.place = {point->x(), point->y(), point->z()};
  if (const auto& texel = result.saved.texel) row.place = {double(texel->x), double(texel->y)};
  if (result.probe) row.figures = figuresOf(*result.probe, result.truth);
  return row;
}

// All results have the same techniques.
std::vector<std::string> techniquesOf(const std::vector<NamedResult>& results) {
  std::vector<std::string> ids;
  for (const NamedResult& result : results) {
    if (!result.probe || !ids.empty()) continue;
    for (const TechniqueResult& technique : result.probe->techniques)
      ids.emplace_back(technique.technique->info().id);
  }
  return ids;
}

}  // namespace

std::vector<NamedProbe> chosenProbes(const Session& session, const std::string& name) {
  if (session.probes.empty())
    throw Error(ErrorKind::BadCommandLine,
                "--named: the session has no saved probes; give one that has with --session");
  if (name == "all") return session.probes;
  if (const NamedProbe* probe = probeNamed(session.probes, name)) return {*probe};
  throw Error(ErrorKind::BadCommandLine, "--named: there is no probe '" + name + "'; there are " +
                                             joined(namesOf(session.probes)) + ", and all");
}

Json namedToJson(const Json& source, const std::vector<NamedResult>& results) {
  Json probes = Json::array();
  for (const NamedResult& result : results) {
    Json probe = {{"name", result.saved.name}};
    if (!result.probe) probe["reason"] = result.reason;
    for (const auto& [key, value] : result.json.items())
      if (key != "format" && key != "source") probe[key] = value;
    probes.push_back(std::move(probe));
  }
  return {{"format", "umbrascope-probes/1"}, {"source", source}, {"probes", probes}};
}

std::string namedText(const std::vector<NamedResult>& results) {
  const std::vector<std::string> techniques = techniquesOf(results);
  TableRow heading{"PROBE", "RECEIVER", "REFERENCE"};
  heading.insert(heading.end(), techniques.begin(), techniques.end());
  std::vector<TableRow> rows{heading};
  std::string reasons;
  for (const NamedResult& result : results) {
    TableRow& row = rows.emplace_back(TableRow{result.saved.name});
    if (!result.probe) reasons += result.saved.name + ": " + result.reason + "\n";
    const std::optional<SheetFigures> figures = sheetRowOf(result).figures;
    row.push_back(figures ? shortNumber(figures->receiver) : "-");
    row.push_back(figures ? shortNumber(figures->reference) : "-");
    for (const std::string& id : techniques) {
      const SheetFigures::Entry* entry = figures ? figures->of(id) : nullptr;
      row.push_back(entry ? shortNumber(entry->visibility) : "-");
    }
  }
  return tableText(rows) + (reasons.empty() ? "" : "\n" + reasons);
}

void writeNamed(OutputFolder& folder, const Json& object, const std::vector<NamedResult>& results) {
  std::vector<SheetRow> rows;
  for (const NamedResult& result : results) rows.push_back(sheetRowOf(result));
  writeTextAtomically(folder.file("probes.json"), toText(object));
  writeTextAtomically(folder.file("probes.csv"), sheetText(rows, techniquesOf(results), ','));
}

}  // namespace umbra
