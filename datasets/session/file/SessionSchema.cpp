#include "datasets/session/file/SessionSchema.h"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "datasets/session/file/SessionFile.h"
#include "datasets/session/file/SessionFileSettings.h"

namespace umbra {

using Json = nlohmann::ordered_json;

namespace {

Json closed(Json properties) {
  return {
      {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

Json closed(Json properties, const std::vector<std::string>& required) {
  Json object = closed(std::move(properties));
  object["required"] = required;
  return object;
}

Json number(double low, double high) {
  return {{"type", "number"}, {"minimum", low}, {"maximum", high}};
}

Json whole(int low, int high) {
  return {{"type", "integer"}, {"minimum", low}, {"maximum", high}};
}

Json list(Json items, std::size_t fewest, std::size_t most) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", fewest}, {"maxItems", most}};
}

Json properties(std::span<const Setting> settings);

Json cameraSchema() {
  Camera camera;
  return closed(properties(settingsOf(camera)));
}

// Says which values are right, but not what they mean.
Json valuesOf(const SettingInfo& info) {
  switch (info.kind) {
    case SettingKind::Switch:
      return {{"type", "boolean"}};
    case SettingKind::Whole:
      return info.values.empty() ? whole(int(info.low), int(info.high))
                                 : Json{{"enum", info.values}};
    case SettingKind::Number:
      if (info.automatic.empty()) return number(info.low, info.high);
      return {{"anyOf", {Json{{"const", 0}}, number(info.low, info.high)}}};
    case SettingKind::Choice:
      return {{"enum", info.choices}};
    case SettingKind::Point:
      return list(number(info.low, info.high), 3, 3);
    case SettingKind::Size:
      return list(whole(int(info.low), int(info.high)), 2, 2);
    case SettingKind::Camera:
      break;
  }
  return cameraSchema();
}

std::string descriptionOf(const SettingInfo& info) {
  std::string text(info.doc);
  if (!info.unit.empty()) text += ", in " + std::string(info.unit);
  if (!info.automatic.empty()) text += "; 0 stands for " + std::string(info.automatic);
  return text;
}

// The properties are nested as in the file; the first part of each key is left out.
Json properties(std::span<const Setting> settings) {
  Json object = Json::object();
  for (const Setting& setting : settings) {
    const std::string_view key = setting.info.key;
    Json* place = &object;
    for (std::string_view rest = key.substr(key.find('.') + 1); !rest.empty();) {
      const std::string part(rest.substr(0, rest.find('.')));
      rest.remove_prefix(std::min(rest.size(), part.size() + 1));
      place = &(*place)[part];
      if (rest.empty()) break;
      if (place->is_null()) *place = closed(Json::object());
      place = &(*place)["properties"];
    }
    *place = valuesOf(setting.info);
    (*place)["description"] = descriptionOf(setting.info);
    const Json usual = toJson(setting.info, setting.defaultValue);
    if (!usual.is_null()) (*place)["default"] = usual;
  }
  return object;
}

Json schemaOf(const ParameterView& parameter) {
  Json schema;
  if (!parameter.choices.empty())
    schema = {{"enum", parameter.choices}};
  else if (std::holds_alternative<int>(parameter.defaultValue))
    schema = whole(int(parameter.low), int(parameter.high));
  else
    schema = number(parameter.low, parameter.high);
  if (std::holds_alternative<std::vector<double>>(parameter.defaultValue))
    schema = {{"type", "array"}, {"items", schema}};
  schema["description"] = parameter.doc;
  schema["default"] = toJson(parameter.defaultValue);
  return schema;
}

// Returns the parameters of each technique by its id.
Json parametersSchema() {
  Json techniques = Json::object();
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* technique : catalogue.all()) {
    Json parameters = Json::object();
    for (const ParameterView& parameter : technique->parameters())
      parameters[std::string(parameter.name)] = schemaOf(parameter);
    techniques[std::string(technique->info().id)] = closed(std::move(parameters));
  }
  return techniques;
}

Json techniqueNames() {
  Json names = Json::array();
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* technique : catalogue.all()) names.push_back(technique->info().id);
  return {{"enum", names}};
}

Json sourceSchema() {
  const Json text{{"type", "string"}};
  const Json anyNumber{{"type", "number"}};
  return {{"oneOf",
           {closed({{"scene", text},
                    {"parameters", {{"type", "object"}, {"additionalProperties", anyNumber}}}},
                   {"scene"}),
            closed({{"mesh", text}, {"up", {{"enum", {"y", "z"}}}}}, {"mesh"}),
            closed({{"depth", text},
                    {"channel", text},
                    {"range", list(anyNumber, 2, 2)},
                    {"projection", text},
                    {"miss", text}},
                   {"depth"})}}};
}

// A pane's parameters are those of one technique, which is the one that its "technique" says.
Json paneSchema(const Json& parameters) {
  Json ofOne = Json::array();
  for (const auto& [id, schema] : parameters.items()) ofOne.push_back(schema);
  FrameSettings frame;
  Json pane{{"technique", techniqueNames()},
            {"active", {{"type", "boolean"}}},
            {"parameters", {{"anyOf", ofOne}}}};
  pane.update(properties(paneSettingsOf(frame)));
  return closed(std::move(pane), {"technique"});
}

Json comparisonSchema(const Json& parameters) {
  Json modes = Json::array();
  for (const auto mode : {ComparisonMode::Single, ComparisonMode::Wipe, ComparisonMode::Grid})
    modes.push_back(nameOf(mode));
  return closed({{"mode", {{"enum", modes}}},
                 {"techniques", list(techniqueNames(), 0, Comparison::most)},
                 {"panes", list(paneSchema(parameters), 0, Comparison::most)},
                 {"wipe", number(0.0, 1.0)}});
}

Json probesSchema() {
  const Json point = list(number(-largestCoordinate, largestCoordinate), 3, 3);
  const Json texel = list(whole(0, Session::largestSide - 1), 2, 2);
  const Json probe = closed({{"name", {{"type", "string"}}},
                             {"point", point},
                             {"texel", texel},
                             {"receiver", number(0.0, 1.0)}},
                            {"name"});
  return list(probe, 0, NamedProbe::most);
}

}  // namespace

Json sessionSchema() {
  Session session;
  Light light;
  const Json parameters = parametersSchema();
  Json keys{{"format", {{"const", sessionFormat}}},
            {"source", sourceSchema()},
            {"light", closed(properties(settingsOf(light)))},
            {"camera", cameraSchema()},
            {"frame", closed(properties(settingsOf(session.frame)))},
            {"technique", techniqueNames()},
            {"parameters", closed(parameters)},
            {"compare", comparisonSchema(parameters)}};
  keys.update(properties(pictureSettingsOf(session)));
  keys["probe"] = list(whole(0, Session::largestSide - 1), 2, 2);
  keys["receiver"] = number(0.0, 1.0);
  keys["probes"] = probesSchema();
  keys["keptProbe"] = {{"type", "string"}};
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Umbrascope session"},
              {"description", "Light and camera that are absent are the scene's own"}};
  schema.update(closed(std::move(keys), {"format"}));
  return schema;
}

}  // namespace umbra
