// The size from which on an error of visibility is called an error, everywhere in the program.
#pragma once

#include <cmath>

namespace umbra {

// One step of an 8-bit picture. Displays show 8 bits a channel: where the error is smaller, the
// picture with it and the picture without it differ by rounding alone, and nobody can tell them
// apart. From one step on every pixel with the error differs.
inline constexpr double visibleError = 1.0 / 255.0;

// Whether an error, visibility − reference, is one that can be seen.
inline bool isVisibleError(double error) {
  return std::abs(error) >= visibleError;
}

}  // namespace umbra
