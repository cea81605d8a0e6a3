// Makes the JSON schema of a session's file from the tables of settings and parameters, so that an
// editor can complete and check what is written by hand. See SessionFile.h.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace umbra {

// The schema follows draft 2020-12. Each object is closed: a key that it does not name is wrong.
nlohmann::ordered_json sessionSchema();

}  // namespace umbra
