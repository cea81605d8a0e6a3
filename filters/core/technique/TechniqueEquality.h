// Whether two instances of techniques are one and the same, as they were set.
#pragma once

#include "filters/core/technique/Technique.h"

namespace umbra {

// The same technique with equal parameters: both encode and reconstruct alike until a map or a
// format adapts one of them.
bool sameSettings(const Technique& a, const Technique& b);

}  // namespace umbra
