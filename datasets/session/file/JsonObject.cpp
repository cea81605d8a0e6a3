#include "datasets/session/file/JsonObject.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "datasets/json/JsonText.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

using Json = nlohmann::ordered_json;

namespace {

// Bytes of a name of ours, of which none is half as long: messages quote names whole.
constexpr std::size_t longestName = 80;

}  // namespace

JsonObject::JsonObject(const Json& value, std::string where)
    : value_(value), where_(std::move(where)) {
  if (!value_.is_object())
    throw Error(ErrorKind::BadInput, where_ + ": " + quoted(value_) + " should be an object {…}");
}

std::string JsonObject::whereOf(std::string_view key) const {
  // "file: a" and key "b" give "file: a.b".
  const bool nested = where_.find(": ") != std::string::npos;
  return where_ + (nested ? "." : ": ") + clipped(key);
}

void JsonObject::refuse(std::string_view key, const std::string& right) const {
  throw Error(ErrorKind::BadInput, whereOf(key) + ": " + quoted(value_.at(std::string(key))) +
                                       " is not right, it takes " + right);
}

const Json* JsonObject::find(std::string_view key) {
  known_.emplace_back(key);
  const auto found = value_.find(std::string(key));
  return found == value_.end() ? nullptr : &*found;
}

void JsonObject::read(std::string_view key, double& target, double low, double high) {
  const Json* value = find(key);
  if (!value) return;
  const bool fits = value->is_number() && std::isfinite(value->get<double>()) &&
                    value->get<double>() >= low && value->get<double>() <= high;
  if (!fits) refuse(key, "a number from " + shortNumber(low) + " to " + shortNumber(high));
  target = value->get<double>();
}

void JsonObject::read(std::string_view key, int& target, int low, int high) {
  const Json* value = find(key);
  if (!value) return;
  // As double first: a whole number beyond 64 bits would wrap.
  const bool fits =
      value->is_number_integer() && value->get<double>() >= low && value->get<double>() <= high;
  if (!fits)
    refuse(key, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  target = value->get<int>();
}

void JsonObject::read(std::string_view key, bool& target) {
  const Json* value = find(key);
  if (!value) return;
  if (!value->is_boolean()) refuse(key, "true or false");
  target = value->get<bool>();
}

void JsonObject::read(std::string_view key, std::string& target) {
  const Json* value = find(key);
  if (!value) return;
  if (!value->is_string()) refuse(key, "a text");
  target = value->get<std::string>();
}

void JsonObject::readName(
    std::string_view key,
    const std::function<void(const std::string& name, const std::string& where)>& parse) {
  std::string name;
  if (!value_.contains(std::string(key))) return void(known_.emplace_back(key));
  read(key, name);
  if (name.size() > longestName) refuse(key, "a name");
  try {
    parse(name, whereOf(key));
  } catch (const Error& error) {
    throw Error(ErrorKind::BadInput, error.what());
  }
}

void JsonObject::readValue(std::string_view key,
                           const std::function<void(const Json&, const std::string&)>& visit) {
  if (const Json* value = find(key)) visit(*value, whereOf(key));
}

void JsonObject::readVector(std::string_view key, double (&target)[3]) {
  const Json* value = find(key);
  if (!value) return;
  const bool fits = value->is_array() && value->size() == 3 &&
                    std::all_of(value->begin(), value->end(), [](const Json& element) {
                      return element.is_number() && std::isfinite(element.get<double>());
                    });
  if (!fits) refuse(key, "three numbers [x, y, z]");
  for (std::size_t i = 0; i < 3; ++i) target[i] = (*value)[i].get<double>();
}

void JsonObject::readObject(std::string_view key, const std::function<void(JsonObject&)>& visit) {
  const Json* value = find(key);
  if (!value) return;
  JsonObject object(*value, whereOf(key));
  visit(object);
  object.finish();
}

void JsonObject::readList(std::string_view key,
                          const std::function<void(const Json&, const std::string&)>& visit) {
  const Json* value = find(key);
  if (!value) return;
  if (!value->is_array()) refuse(key, "a list […]");
  for (std::size_t i = 0; i < value->size(); ++i)
    visit((*value)[i], whereOf(key) + "[" + std::to_string(i + 1) + "]");
}

void JsonObject::readLines(std::string_view key, std::string& target) {
  const Json* value = find(key);
  if (!value) return;
  const bool lines =
      value->is_array() && !value->empty() &&
      std::all_of(value->begin(), value->end(), [](const Json& line) { return line.is_string(); });
  if (!lines && !value->is_string()) refuse(key, "a text, or a list of its lines");
  if (!lines) return void(target = value->get<std::string>());
  target.clear();
  for (const Json& line : *value) target += (target.empty() ? "" : "\n") + line.get<std::string>();
}

void JsonObject::readRest(
    const std::function<void(const std::string&, const Json&, const std::string&)>& visit) {
  for (const auto& [key, value] : value_.items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    known_.push_back(key);
    visit(key, value, whereOf(key));
  }
}

void JsonObject::finish() const {
  for (const auto& [key, value] : value_.items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string nearest = nearestWord(key, known_);
    throw Error(ErrorKind::BadInput, whereOf(key) + ": there is no such key; " +
                                         (nearest.empty() ? "there are " + joined(known_)
                                                          : "did you mean '" + nearest + "'?"));
  }
}

}  // namespace umbra
