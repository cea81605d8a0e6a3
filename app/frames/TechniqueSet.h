// The techniques that a command works with, with the session's parameters.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/options/SessionOptions.h"
#include "datasets/session/Session.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// Makes one technique for each id; the log says what the storage format limited. A technique that
// cannot be composed with the session's format, kernel or read is left out, and a line in the log
// says why. Where it was named, or none is left, that is an error (BadCommandLine).
std::vector<std::shared_ptr<Technique>> makeTechniques(const Session& session,
                                                       const TechniqueCatalogue& catalogue,
                                                       const TechniqueChoice& choice);

// Why textures on the GPU cannot have the session's format; "" where they can.
std::string whyNoGpuFormat(const Session& session);
// Throws BadCommandLine with that sentence.
void checkGpuFormat(const Session& session);

}  // namespace umbra
