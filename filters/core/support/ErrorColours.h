// The colours of signed errors, the same in pictures, legends and mesh files. Components in [0,1].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace umbra {

using ViewColour = std::array<float, 3>;

// Signed error: neutral at 0, red where light bleeds, blue where it is too dark. Neutral is white;
// the picture dims it a little by the surface's own shading.
inline constexpr ViewColour noErrorColour{1.0f, 1.0f, 1.0f};
inline constexpr ViewColour bleedingColour{0.79f, 0.0f, 0.12f};
inline constexpr ViewColour darkeningColour{0.02f, 0.31f, 0.73f};

// An error of the size 1, the largest, has its full colour.
inline ViewColour colourOfError(double error) {
  const ViewColour& end = error > 0.0 ? bleedingColour : darkeningColour;
  const float share = float(std::min(std::abs(error), 1.0));
  ViewColour colour{};
  for (int c = 0; c < 3; ++c) colour[c] = noErrorColour[c] + share * (end[c] - noErrorColour[c]);
  return colour;
}

}  // namespace umbra
