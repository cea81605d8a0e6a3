// A small depth map with two planes, noise, a gap and an edge.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "datasets/maps/ExrFile.h"

namespace umbra::cli {

inline Image<float> smallMap(int width = 24, int height = 17) {
  Image<float> map(width, height);
  std::uint32_t state = 12345;  // a linear congruential generator: the same map everywhere
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      state = state * 1664525u + 1013904223u;
      const float noise = float(state >> 8) / float(1u << 24);
      map(x, y) = x < width / 3 ? 0.25f : y < height / 2 ? 0.6f + 0.1f * noise : noise;
    }
  map(width - 1, height - 1) = 1.0f;
  return map;
}

inline void writeMap(const std::string& file, const Image<float>& map,
                     const std::string& channel = "Z") {
  writeExr(file, {{channel, map}}, {});
}

}  // namespace umbra::cli
