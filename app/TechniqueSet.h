// The techniques that a command works on, with the session's parameters.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "datasets/Session.h"
#include "filters/core/Technique.h"

namespace umbra {

// One technique per id; says in the log what the storage format limited. Throws BadCommandLine
// where a technique cannot be stored in the session's format, and says why.
std::vector<std::shared_ptr<Technique>> makeTechniques(const Session& session,
                                                       const TechniqueCatalogue& catalogue,
                                                       const std::vector<std::string>& ids);

// Throws BadCommandLine unless the format is one that textures on the GPU take.
void checkGpuFormat(const Session& session);

}  // namespace umbra
