// Where a trilinear or anisotropic read falls in the mip levels of a prefiltered map.
#pragma once

#include <vector>

#include "filters/core/maps/Region.h"

namespace umbra {

// A bilinear read of one level. Level 0 is the prefiltered map, of width × height texels. With P
// the next power of two of the longer side, level L ≥ 1 has P >> L texels a side; its texel i
// reduces the texels [i·2^L, (i+1)·2^L) of level 0. Texels beyond the map's edge repeat the edge.
struct LevelRead {
  int level = 0;
  // The two texels of the level that are mixed along either axis, clamped to it, and the weight of
  // the second.
  int x[2] = {0, 0}, y[2] = {0, 0};
  double fx = 0.0, fy = 0.0;
  double weight = 1.0;  // of this read among all of them; these sum to 1
};

// The number of levels above the map itself; the last one is a single texel.
int mipLevels(int width, int height);

// The reads of the levels for a trilinear or anisotropic read: two levels for each probe, or one
// where λ is a whole number. λ = log2(footprint / probes), limited to 0 … the last level.
std::vector<LevelRead> levelReadsOf(const ReadPoint& read, int width, int height);

}  // namespace umbra
