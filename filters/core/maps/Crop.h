// A part of a map as a map of its own.
#pragma once

#include <algorithm>

#include "filters/core/maps/Image.h"

namespace umbra {

// `width` by `height` texels from (left, top) on; those beyond the map's border repeat its edge.
inline DepthMap croppedMap(const DepthMap& map, int left, int top, int width, int height) {
  DepthMap crop(width, height, map.channels());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      std::ranges::copy(map.pixel(std::clamp(left + x, 0, map.width() - 1),
                                  std::clamp(top + y, 0, map.height() - 1)),
                        crop.pixel(x, y).begin());
  return crop;
}

}  // namespace umbra
