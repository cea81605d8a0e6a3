// The parts of a session's file that say how techniques are set: see SessionFile.h.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "datasets/session/Session.h"
#include "datasets/session/file/JsonObject.h"

namespace umbra {

nlohmann::ordered_json toJson(const ParameterValue& value);
nlohmann::ordered_json toJson(const ParameterValues& values);

// Both are checked against the techniques' own tables, so that an error names its key here and not
// later. Throw BadInput for an unknown technique or parameter, a value out of range, and values
// that contradict each other.
void readParameters(JsonObject& object, TechniqueParameters& parameters);
// Reads the values of the technique `id`, which must exist.
ParameterValues readParameterValues(JsonObject& object, const std::string& id);

}  // namespace umbra
