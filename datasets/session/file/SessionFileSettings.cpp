#include "datasets/session/file/SessionFileSettings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "datasets/json/JsonText.h"
#include "filters/core/settings/SettingRow.h"
#include "filters/core/support/Text.h"

namespace umbra {

using Json = nlohmann::ordered_json;

namespace {

// Takes off the key's first part, which names the object that is read or written. A key of one part
// stands in the file's outermost object.
std::string_view below(std::string_view key) {
  return key.substr(key.find('.') + 1);
}

std::string_view firstPart(std::string_view key) {
  return key.substr(0, key.find('.'));
}

// Returns none for a value that no setting can have.
std::optional<SettingValue> valueIn(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer() && std::abs(json.get<double>()) <= 1e9) return json.get<int>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  const bool numbers =
      json.is_array() &&
      std::all_of(json.begin(), json.end(), [](const Json& part) { return part.is_number(); });
  if (!numbers) return std::nullopt;
  return json.get<std::vector<double>>();
}

// The first `done` characters of each key lead to `object`.
void readBelow(JsonObject& object, std::span<const Setting> settings, std::size_t done) {
  std::vector<std::string> visited;  // objects within it
  for (const Setting& setting : settings) {
    const std::string_view rest = setting.info.key.substr(done);
    const std::string part(firstPart(rest));
    if (part == rest) {
      object.readValue(part, [&](const Json& value, const std::string& where) {
        setting.put(settingFrom(setting.info, value, where));
      });
    } else if (std::find(visited.begin(), visited.end(), part) == visited.end()) {
      visited.push_back(part);
      std::vector<Setting> within;
      for (const Setting& other : settings)
        if (other.info.key.substr(done).starts_with(part + ".")) within.push_back(other);
      object.readObject(
          part, [&](JsonObject& inner) { readBelow(inner, within, done + part.size() + 1); });
    }
  }
}

}  // namespace

Json toJson(const SettingInfo& info, const SettingValue& value) {
  const auto* list = std::get_if<std::vector<double>>(&value);
  if (list && info.kind == SettingKind::Size) return {int((*list)[0]), int((*list)[1])};
  if (list && info.kind == SettingKind::Camera)
    return list->empty() ? Json() : cameraJson(*detail::cameraFrom(*list));
  return std::visit([](const auto& held) { return Json(held); }, value);
}

SettingValue settingFrom(const SettingInfo& info, const Json& json, const std::string& where) {
  if (info.kind == SettingKind::Camera) {
    JsonObject object(json, where);
    const Camera camera = cameraFrom(object);
    object.finish();
    return detail::numbersOf(camera);
  }
  const std::optional<SettingValue> value = valueIn(json);
  const std::string found =
      json.is_string() ? "'" + clipped(json.get<std::string>()) + "'" : quoted(json);
  if (!value) refuseSetting(info, where, found);
  return checked(info, *value, where, found);
}

void writeSettings(Json& object, std::span<const Setting> settings) {
  for (const Setting& setting : settings) {
    const Json value = toJson(setting.info, setting.get());
    if (value.is_null()) continue;
    Json* place = &object;
    for (std::string_view rest = below(setting.info.key); !rest.empty();) {
      const std::string_view part = firstPart(rest);
      place = &(*place)[std::string(part)];
      rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    }
    *place = value;
  }
}

void readSettings(JsonObject& object, std::span<const Setting> settings) {
  if (settings.empty()) return;
  const std::string_view key = settings.front().info.key;
  readBelow(object, settings, key.size() - below(key).size());
}

std::vector<Setting> paneSettingsOf(FrameSettings& frame) {
  std::vector<Setting> settings = settingsOf(frame);
  std::erase_if(settings, [](const Setting& setting) { return !setting.info.pane; });
  return settings;
}

std::vector<std::string> paneKeys(PaneSetting setting) {
  std::vector<std::string> keys;
  for (const auto& row : frameTable()) {
    const std::string key(firstPart(below(row.info.key)));
    const bool known = std::find(keys.begin(), keys.end(), key) != keys.end();
    if (row.info.pane == setting && !known) keys.push_back(key);
  }
  return keys;
}

Json pointJson(const Eigen::Vector3d& point) {
  return {point.x(), point.y(), point.z()};
}

Json cameraJson(const Camera& camera) {
  Camera written = camera;
  Json json;
  writeSettings(json, settingsOf(written));
  return json;
}

Json lightJson(const Light& light) {
  Light written = light;
  Json json;
  writeSettings(json, settingsOf(written));
  return json;
}

void readPoint(JsonObject& object, std::string_view key, Eigen::Vector3d& target) {
  double values[3] = {target.x(), target.y(), target.z()};
  object.readVector(key, values);
  target = {values[0], values[1], values[2]};
}

Camera cameraFrom(JsonObject& object) {
  Camera camera;
  readSettings(object, settingsOf(camera));
  validate(camera, object.where());
  return camera;
}

Light lightFrom(JsonObject& object) {
  Light light;
  readSettings(object, settingsOf(light));
  validate(light, object.where());
  return light;
}

}  // namespace umbra
