// Which settings of a frame a technique cannot be composed with, and why.
#pragma once

#include <string>

#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// Why `technique` cannot be drawn with this storage format, kernel and read; empty where it can.
// One sentence that names the setting and says what would go.
std::string whyImpossible(const FrameSettings& frame, const Technique& technique);

// Why the picture of a technique that can be drawn is not what its regions would give, whatever
// their errors; empty where it is. One sentence, for a notice.
std::string whyInexact(const FrameSettings& frame, const Technique& technique);

}  // namespace umbra
