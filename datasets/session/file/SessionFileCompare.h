// The part of a session's file that says what is compared: see SessionFile.h.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "datasets/session/Session.h"
#include "datasets/session/file/JsonObject.h"

namespace umbra {

// Makes the session what its file says: own settings stand in every pane, the rest is shared.
void takeApart(Session& session);
// Of a session that is taken apart.
nlohmann::ordered_json comparisonJson(const Session& session);
// Into a session that has read technique, parameters and frame. Throws BadInput that names the key.
void readComparison(JsonObject& object, Session& session);

}  // namespace umbra
