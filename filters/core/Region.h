// The texels that one filtered read averages: the region that a probe takes apart.
#pragma once

#include <vector>

#include "filters/core/Image.h"
#include "filters/core/Kernel.h"

namespace umbra {

struct RegionTexel {
  int x = 0, y = 0;     // pixel in the depth map, after clamping to the border
  double depth = 0.0;   // [0,1]
  double weight = 0.0;  // the weights of a region sum to 1
};

struct Region {
  int x = 0, y = 0;  // the texel nearest to the read position
  Kernel kernel;
  // Row by row. A tap beyond the border repeats the edge texel, so one pixel may occur twice.
  std::vector<RegionTexel> texels;
  double nearestDepth = 1.0;  // the depth at (x, y)
};

// The (2r+1)² taps around texel (x, y): what a point read of the prefiltered map averages.
// Throws BadCommandLine when (x, y) is outside the map.
Region regionAtTexel(const DepthMap& map, const Kernel& kernel, int x, int y);

// The (2r+2)² taps of a bilinear read of the prefiltered map at (u, v), both in [0,1] from the
// top-left corner: the kernel convolved with the bilinear weights.
Region regionBilinear(const DepthMap& map, const Kernel& kernel, double u, double v);

struct RegionStatistics {
  double mean = 0.0;          // M1
  double secondMoment = 0.0;  // M2
  double variance = 0.0;      // M2 − M1², evaluated about the mean so that it never cancels
  double min = 0.0, max = 0.0;
  double beta = 0.0;  // (mean − min) / (max − mean), Gumbau 2011, eq. 3; infinite for max = mean
};

RegionStatistics statisticsOf(const Region& region);

// Exact percentage-closer filtering, Σ w [z ≥ receiver]: the truth for every technique.
double referenceVisibility(const Region& region, double receiver);

}  // namespace umbra
