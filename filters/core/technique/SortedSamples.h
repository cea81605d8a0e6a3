// Weighted samples in ascending order with running sums, so that an iteration of Lloyd's relaxation
// costs a few look-ups however many samples there are.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "filters/core/technique/Lloyd.h"

namespace umbra {

class SortedSamples {
 public:
  // Samples without weight are left out. Values must be finite and weights ≥ 0.
  explicit SortedSamples(std::vector<WeightedSample> samples);

  bool empty() const { return samples_.empty(); }
  // Ascending; every weight is above 0.
  std::span<const WeightedSample> samples() const { return samples_; }
  // Sums of the ends.size() + 1 clusters that ascending `ends` divide the samples into, as
  // Relaxation::ends describes them.
  std::vector<ClusterSums> clusters(std::span<const double> ends) const;
  // Σ w·(x − nearest split)² / Σ w of ascending splits, depth²: what the relaxation lowers. 0 where
  // there are no samples or no splits.
  double cost(std::span<const double> splits) const;

 private:
  // Differences of running sums are the sums of a range. They are kept in long double, about
  // mid-depth, lest the difference lose digits.
  struct Sums {
    long double weight = 0.0L, first = 0.0L, second = 0.0L;
  };

  std::size_t countUpTo(double value) const;
  ClusterSums sums(std::size_t begin, std::size_t end) const;

  std::vector<WeightedSample> samples_;
  std::vector<Sums> sums_;
};

}  // namespace umbra
