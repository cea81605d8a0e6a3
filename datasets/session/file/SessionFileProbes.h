// The part of a session's file that holds the saved probes: see SessionFile.h.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "datasets/session/Session.h"
#include "datasets/session/file/JsonObject.h"

namespace umbra {

nlohmann::ordered_json probesJson(const std::vector<NamedProbe>& probes);

// The keys "probes" and "keptProbe" of `object`, a session whose source and probe are known. Throws
// BadInput that names the key, with the probe's place from 1.
void readProbes(JsonObject& object, Session& session);

}  // namespace umbra
