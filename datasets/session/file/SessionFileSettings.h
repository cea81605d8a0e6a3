// Reads and writes the parts of a session's file that a table of settings declares: see
// SessionFile.h and SessionSettings.h.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/session/SessionSettings.h"
#include "datasets/session/file/JsonObject.h"

namespace umbra {

// Writes each setting at its key without the first part: "frame.kernel.radius" is written into a
// frame's object as "kernel": {"radius": …}.
void writeSettings(nlohmann::ordered_json& object, std::span<const Setting> settings);
// Settings whose keys are absent stay as they are. Throws BadInput that names the key.
void readSettings(JsonObject& object, std::span<const Setting> settings);

// These convert a value to what a file holds, which is null if there is no camera, and back. The
// second throws BadInput for a value that is not right; its message begins with `where`.
nlohmann::ordered_json toJson(const SettingInfo& info, const SettingValue& value);
SettingValue settingFrom(const SettingInfo& info, const nlohmann::ordered_json& json,
                         const std::string& where);

// Returns the settings that a pane may have of its own.
std::vector<Setting> paneSettingsOf(FrameSettings& frame);
// Returns the keys of a pane that hold one group: "filter", "anisotropy" and "sat" for the read.
std::vector<std::string> paneKeys(PaneSetting setting);

nlohmann::ordered_json pointJson(const Eigen::Vector3d& point);
nlohmann::ordered_json cameraJson(const Camera& camera);
nlohmann::ordered_json lightJson(const Light& light);
// All throw BadInput that names the key.
void readPoint(JsonObject& object, std::string_view key, Eigen::Vector3d& target);
Camera cameraFrom(JsonObject& object);
Light lightFrom(JsonObject& object);

}  // namespace umbra
