#include "datasets/session/file/SessionFileCompare.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "datasets/json/JsonText.h"
#include "datasets/session/file/SessionFileParameters.h"
#include "datasets/session/file/SessionFileSettings.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

using Json = nlohmann::ordered_json;

namespace {

[[noreturn]] void refuseList(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::BadInput, where + ": " + why);
}

std::size_t placeOf(const std::vector<Pane>& panes, const std::string& technique) {
  const auto found = std::find_if(panes.begin(), panes.end(),
                                  [&](const Pane& pane) { return pane.technique == technique; });
  return std::size_t(found - panes.begin());
}

// Nothing but a list of techniques, none twice.
bool isList(const std::vector<Pane>& panes) {
  for (std::size_t i = 0; i < panes.size(); ++i)
    if (!panes[i].linked() || placeOf(panes, panes[i].technique) != i) return false;
  return true;
}

Json paneJson(const Pane& pane, bool active) {
  Json json{{"technique", pane.technique}};
  if (active) json["active"] = true;
  if (pane.own.parameters) json["parameters"] = toJson(*pane.own.parameters);
  FrameSettings frame;
  std::vector<Setting> own = paneSettingsOf(frame);
  std::erase_if(own, [&](const Setting& setting) {
    const auto found = pane.own.values.find(std::string(setting.info.name));
    if (found != pane.own.values.end()) setting.put(found->second);
    return found == pane.own.values.end();
  });
  writeSettings(json, own);
  return json;
}

Pane paneFrom(const Json& value, const std::string& where, const FrameSettings& shared,
              bool& active) {
  JsonObject object(value, where);
  Pane pane;
  object.readName("technique", [&](const std::string& id, const std::string& place) {
    pane.technique = allTechniques().make(id, place)->info().id;
  });
  if (pane.technique.empty()) refuseList(where, "needs a \"technique\"");
  object.read("active", active);
  object.readObject("parameters", [&](JsonObject& parameters) {
    pane.own.parameters = readParameterValues(parameters, pane.technique);
  });
  FrameSettings frame = shared;
  if (value.contains("cascades")) frame.map.cascades.frozen.reset();  // absent means so
  readSettings(object, paneSettingsOf(frame));
  object.finish();
  for (const Setting& setting : paneSettingsOf(frame))
    for (const std::string& key : paneKeys(*setting.info.pane))
      if (value.contains(key)) pane.own.values[std::string(setting.info.name)] = setting.get();
  return pane;
}

void readTechniques(JsonObject& object, std::vector<Pane>& panes) {
  object.readList("techniques", [&](const Json& element, const std::string& where) {
    const std::string id = element.is_string() ? element.get<std::string>() : quoted(element);
    if (!allTechniques().has(id)) refuseList(where, "there is no technique " + clipped(id));
    if (placeOf(panes, id) != panes.size())
      refuseList(where,
                 "has " + id + " twice, each is compared once unless \"panes\" set it apart");
    panes.push_back({id, {}});
  });
}

// The active pane is the one that says so, else the first of the shared technique.
void readPanes(JsonObject& object, const Session& shared, Comparison& comparison) {
  std::string activeAt;
  object.readList("panes", [&](const Json& element, const std::string& where) {
    bool active = false;
    comparison.panes.push_back(paneFrom(element, where, shared.frame, active));
    if (!active) return;
    if (!activeAt.empty())
      refuseList(where + ".active", "one before it is active, only one can be");
    activeAt = where;
    comparison.active = comparison.panes.size() - 1;
  });
  if (comparison.panes.empty()) return;
  if (activeAt.empty()) comparison.active = placeOf(comparison.panes, shared.technique);
  if (comparison.active == comparison.panes.size() ||
      comparison.panes[comparison.active].technique != shared.technique)
    refuseList(activeAt.empty() ? object.where() + ".panes" : activeAt,
               "should show " + shared.technique + ", which \"technique\" says");
}

}  // namespace

Json comparisonJson(const Comparison& comparison) {
  Json json{{"mode", nameOf(comparison.mode)}};
  if (isList(comparison.panes)) {
    json["techniques"] = Json::array();
    for (const Pane& pane : comparison.panes) json["techniques"].push_back(pane.technique);
  } else {
    for (std::size_t i = 0; i < comparison.panes.size(); ++i)
      json["panes"].push_back(paneJson(comparison.panes[i], i == comparison.active));
  }
  json["wipe"] = comparison.wipe;
  return json;
}

Comparison readComparison(JsonObject& object, const Session& shared) {
  Comparison comparison;
  object.readName("mode", [&](const std::string& name, const std::string& where) {
    comparison.mode = comparisonModeFrom(name, where);
  });
  readTechniques(object, comparison.panes);
  const bool listed = !comparison.panes.empty();
  comparison.active = placeOf(comparison.panes, shared.technique);
  if (comparison.active == comparison.panes.size()) comparison.active = 0;
  if (listed)
    object.readList("panes", [](const Json&, const std::string& where) {
      refuseList(where, "\"techniques\" has the panes, it takes one of the two");
    });
  else
    readPanes(object, shared, comparison);
  const std::size_t count = comparison.panes.size();
  if (count != 0 && (count < Comparison::fewest || count > Comparison::most))
    refuseList(object.where() + (listed ? ".techniques" : ".panes"),
               "there are " + std::to_string(count) + ", two to six are compared");
  object.read("wipe", comparison.wipe, 0.0, 1.0);
  return comparison;
}

}  // namespace umbra
