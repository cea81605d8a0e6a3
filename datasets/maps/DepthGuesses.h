// How a depth file is perhaps meant, judged by its values.
#pragma once

#include <string>
#include <vector>

#include "datasets/maps/DepthFile.h"
#include "datasets/maps/RawDepths.h"

namespace umbra {

struct DepthGuess {
  std::string reason;  // one sentence that says what in the values speaks for it
  std::string action;  // what it would do, in a few words
  DepthImport import;  // the present one, changed by it
  // The import lacks the planes of its projection, which no value tells.
  bool needsPlanes = false;
};

// The guesses that would change `present`, the likeliest first.
std::vector<DepthGuess> depthGuesses(const RawDepths& raw, const DepthImport& present);

}  // namespace umbra
