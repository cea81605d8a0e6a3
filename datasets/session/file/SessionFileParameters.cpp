#include "datasets/session/file/SessionFileParameters.h"
#include "datasets/json/JsonText.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "filters/core/support/Error.h"

namespace umbra {

using Json = nlohmann::ordered_json;

namespace {

ParameterValue valueFrom(const Json& json, const std::string& where) {
  if (json.is_number_integer() && std::abs(json.get<double>()) < 1e9) return json.get<int>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  if (json.is_array()) {
    std::vector<double> list;
    for (const Json& element : json) {
      if (!element.is_number())
        throw Error(ErrorKind::BadInput, where + ": " + quoted(element) + " should be a number");
      list.push_back(element.get<double>());
    }
    return list;
  }
  throw Error(ErrorKind::BadInput, where + ": " + quoted(json) + " is no parameter's value");
}

}  // namespace

Json toJson(const ParameterValue& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

Json toJson(const ParameterValues& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = toJson(value);
  return json;
}

ParameterValues readParameterValues(JsonObject& object, const std::string& id) {
  const TechniqueCatalogue catalogue = allTechniques();
  const std::unique_ptr<Technique> technique = catalogue.make(id);
  const std::vector<Parameter> known = technique->parameters();
  ParameterValues values;
  object.readRest([&](const std::string& name, const Json& value, const std::string& where) {
    const Parameter& parameter = parameterNamed(known, name, where);
    parameter.set(valueFrom(value, where), where);
    values[name] = parameter.get();
  });
  if (!values.empty()) checkTogether(values, *catalogue.make(id), object.where());
  return values;
}

void readParameters(JsonObject& object, TechniqueParameters& parameters) {
  const TechniqueCatalogue catalogue = allTechniques();
  object.readRest([&](const std::string& id, const Json& values, const std::string& where) {
    if (!catalogue.has(id))
      throw Error(ErrorKind::BadInput, where + ": there is no such technique");
    JsonObject set(values, where);
    ParameterValues read = readParameterValues(set, id);
    if (!read.empty()) parameters[id] = std::move(read);
  });
}

}  // namespace umbra
