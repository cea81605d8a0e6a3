// The texels that one filtered read averages: the region that a probe takes apart.
#pragma once

#include <vector>

#include "filters/core/maps/Image.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/settings/Kernel.h"

namespace umbra {

// The part of the map that one pixel of the picture covers.
struct Footprint {
  // Texels. For a trilinear or anisotropic read this is the footprint's longer axis, for a
  // summed-area table the box's width and height.
  double x = 0.0, y = 0.0;
  int probes = 1;  // trilinear reads along the axis; 1 for a trilinear read

  bool operator==(const Footprint&) const = default;
};

// Where and how the channels of a map are read.
struct ReadPoint {
  ReadFilter filter = ReadFilter::Point;
  double u = 0.0, v = 0.0;  // in [0,1] from the map's top-left corner, v down
  Footprint footprint;

  static ReadPoint atTexel(const DepthMap& map, int x, int y);
};

struct RegionTexel {
  int x = 0, y = 0;     // texel of the depth map, after clamping to the border
  double depth = 0.0;   // [0,1]
  double weight = 0.0;  // the weights of a region sum to 1
  int cascade = 0;      // the cascade whose map has the texel
};

struct Region {
  int x = 0, y = 0;  // the texel nearest to the read position
  Kernel kernel;
  // Row by row. A tap beyond the border repeats the edge texel, so one pixel may occur twice.
  std::vector<RegionTexel> texels;
  double nearestDepth = 1.0;  // the depth at (x, y), of its first sample
  // The taps of one texel follow each other: this many, one for each sample, of equal weight.
  int samples = 1;
  // How many texels on either side of (x, y) are among the taps, wherever between texels the read
  // is: the kernel's radius, or half of a summed-area table's box. Only the map's border cuts them
  // off.
  int reachX = 0, reachY = 0;
};

// The (2r+1)² taps around texel (x, y): what a point read of the prefiltered map averages.
// Throws BadCommandLine when (x, y) is outside the map.
Region regionAtTexel(const DepthMap& map, const Kernel& kernel, int x, int y);

// The (2r+2)² taps of a bilinear read of the prefiltered map at (u, v), both in [0,1] from the
// top-left corner: the kernel convolved with the bilinear weights.
Region regionBilinear(const DepthMap& map, const Kernel& kernel, double u, double v);

// The taps that `read` averages, with their weights. A point or bilinear read averages the taps of
// the two functions above. A trilinear read mixes two mip levels, each read bilinearly
// (MipLevels.h). An anisotropic read averages as many trilinear ones as the footprint has probes,
// along its axis. Each texel of the map occurs once. A summed-area table averages a box of the
// footprint's size about (u, v), at least one texel wide, and weights a texel by the part of it
// inside the box; the kernel is not applied as well. A map with several samples a texel gives as
// many taps a texel. (u, v) is in [0,1].
Region regionOf(const DepthMap& map, const Kernel& kernel, const ReadPoint& read);

struct RegionStatistics {
  double mean = 0.0;          // M1
  double secondMoment = 0.0;  // M2
  double variance = 0.0;      // M2 − M1², evaluated about the mean so that it never cancels
  double min = 0.0, max = 0.0;
  double beta = 0.0;  // (mean − min) / (max − mean), Gumbau 2011, eq. 3; infinite for max = mean
};

RegionStatistics statisticsOf(const Region& region);

// Exact percentage-closer filtering, Σ w [z ≥ receiver]: the reference for every technique.
double referenceVisibility(const Region& region, double receiver);

}  // namespace umbra
