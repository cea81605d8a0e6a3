// The techniques that a command works on, with the session's parameters.
#pragma once

#include <memory>
#include <vector>

#include "app/options/SessionOptions.h"
#include "datasets/session/Session.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// One technique per id; says in the log what the storage format limited. One that the session's
// format, kernel or read cannot be composed with is left out of all of them, with a line in the log
// that says why; where it was named, or none is left, it is an error (BadCommandLine).
std::vector<std::shared_ptr<Technique>> makeTechniques(const Session& session,
                                                       const TechniqueCatalogue& catalogue,
                                                       const TechniqueChoice& choice);

// Throws BadCommandLine unless the format is one that textures on the GPU take.
void checkGpuFormat(const Session& session);

}  // namespace umbra
