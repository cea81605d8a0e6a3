// The parts of a session's file that say how a frame is drawn: see SessionFile.h.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "datasets/session/file/JsonObject.h"
#include "filters/core/scene/Camera.h"
#include "filters/core/settings/FrameSettings.h"

namespace umbra {

nlohmann::ordered_json pointJson(const Eigen::Vector3d& point);
nlohmann::ordered_json cameraJson(const Camera& camera);
nlohmann::ordered_json frameJson(const FrameSettings& frame);

// All throw BadInput that names the key.
void readPoint(JsonObject& object, std::string_view key, Eigen::Vector3d& target);
Camera cameraFrom(JsonObject& object);
void readFrame(JsonObject& object, FrameSettings& frame);
void readMapAndReads(JsonObject& object, FrameSettings& frame);  // all but "view"

}  // namespace umbra
