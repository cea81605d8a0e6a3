// Where to split depth into layers: weighted one-dimensional k-means (Lloyd's relaxation) over the
// second occluders of a shadow map (Lauritzen 2008, §4.1.2–4.1.3).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "filters/core/Image.h"

namespace umbra {

struct WeightedSample {
  double value = 0.0;   // depth; μ + σ may lie a little beyond 1
  double weight = 0.0;  // variance, depth²
};

// Variances below `low` count as `low`, those above `high` as `high`.
struct WeightClamp {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
};

// One sample between every four texels: the mean plus the standard deviation of the four depths,
// which is the farther one where two depths share them evenly, weighted by their variance.
// (width − 1)·(height − 1) samples, row by row; none for a map that is one texel wide or high.
std::vector<WeightedSample> secondOccluderSamples(const DepthMap& map, WeightClamp clamp = {});

struct LloydOptions {
  int splits = 3;              // how many to place, ≥ 0
  int maxIterations = 100000;  // stops there if something still moves
  // How many splits an iteration moves, in turn: 0 is all of them; the paper's interactive mode
  // moves two in a frame.
  int movedPerIteration = 0;
  // Ascending, `splits` values: where to start. Empty is uniform, k/(splits + 1).
  std::vector<double> start;
};

struct LloydResult {
  std::vector<double> splits;  // ascending
  // Σ w·(x − nearest split)² / Σ w as each iteration found it, the first before any move. It never
  // rises. Zeros where no sample has weight.
  std::vector<double> cost;
  int iterations = 0;  // the last one of a converged run moved nothing
  int teleports = 0;   // splits without samples that were moved into the heaviest cluster
};

// Moves each split to the weighted mean of the samples nearest to it until nothing moves. A split
// whose samples weigh nothing is taken out, and the heaviest cluster that has more than one value
// is divided at its mean instead. Values must be finite and weights ≥ 0.
LloydResult relax(std::vector<WeightedSample> samples, const LloydOptions& options);

}  // namespace umbra
