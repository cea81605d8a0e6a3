// A depth map for tests of files.
#pragma once

#include <cmath>

#include "filters/core/maps/Image.h"

namespace umbra {

// An uneven ramp from `low` to `high`, 24 by 16, with one row of `background`.
inline Image<float> rampOver(float low, float high, float background) {
  Image<float> depths(24, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x)
      depths(x, y) = y == 15 ? background : std::lerp(low, high, float(y * 24 + x) / 359.0F);
  return depths;
}

}  // namespace umbra
