// The part of a session's file that says what is compared: see SessionFile.h.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "datasets/session/Comparison.h"
#include "datasets/session/file/JsonObject.h"

namespace umbra {

nlohmann::ordered_json comparisonJson(const Comparison& comparison);
// `shared` has its technique, parameters and frame already. Throws BadInput that names the key.
Comparison readComparison(JsonObject& object, const Session& shared);

}  // namespace umbra
