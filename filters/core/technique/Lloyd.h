// Where to split depth into layers: weighted one-dimensional k-means (Lloyd's relaxation) over the
// second occluders of a shadow map (Lauritzen 2008, §4.1.2–4.1.3).
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "filters/core/maps/Image.h"

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

// One sample between every four texels. Its value is the mean plus the standard deviation of the
// four depths, which is the farther depth where two depths share them evenly; its weight is their
// variance. Where texels have several samples, the first ones count. The result has (width −
// 1)·(height − 1) samples, row by row, and none for a map that is one texel wide or high.
std::vector<WeightedSample> secondOccluderSamples(const DepthMap& map, WeightClamp clamp = {});

struct LloydOptions {
  int splits = 3;              // how many to place, ≥ 0
  int maxIterations = 100000;  // the relaxation stops there even if something still moves
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

// Sums over a cluster's samples of positive weight. They are long sums about mid-depth, since the
// cost is a small difference of them.
struct ClusterSums {
  long double weight = 0.0L, first = 0.0L, second = 0.0L;  // Σw, Σw·u, Σw·u², u = x − ½
  // The range of the samples' values; it is empty where the cluster has no sample.
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

// The relaxation without its samples: it says for which clusters it wants sums, and moves the
// splits when it is given these sums. The splits move alike whether the CPU or the GPU adds up.
class Relaxation {
 public:
  explicit Relaxation(const LloydOptions& options);

  // Whether a whole turn over all splits moved nothing, or the iterations are used up.
  bool settled() const;
  // Ascending values that divide the samples into the clusters whose sums are wanted next: cluster
  // i has the samples above ends()[i − 1] and up to ends()[i]. There are at most as many ends as
  // splits.
  std::vector<double> ends() const;
  // Takes the sums of the ends().size() + 1 clusters, in ascending order.
  void take(std::span<const ClusterSums> clusters);
  // Goes on from the present splits, for other samples. Iterations are counted anew.
  void resume();

  const LloydResult& result() const { return result_; }

 private:
  // A cluster that is to be divided so that a split without samples can move into it.
  struct Division {
    std::size_t heaviest = 0, dead = 0;  // splits
    double end = 0.0;                    // between the two halves
  };

  void divide(std::span<const ClusterSums> clusters, std::size_t dead);
  void teleport(std::span<const ClusterSums> clusters);

  LloydOptions options_;
  LloydResult result_;
  std::optional<Division> division_;  // waits for the sums of the two halves
  std::size_t next_ = 0;              // the split whose turn it is
  std::size_t still_ = 0;             // how many were looked at since anything moved
};

// Moves each split to the weighted mean of the samples nearest to it until nothing moves. A split
// whose samples weigh nothing is taken out, and the heaviest cluster that has more than one value
// is divided at its mean instead. Values must be finite and weights ≥ 0.
LloydResult relax(std::vector<WeightedSample> samples, const LloydOptions& options);

}  // namespace umbra
