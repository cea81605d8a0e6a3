// What a stored channel that differs from the exact one looks like. Nothing is guessed: channels
// are computed under other assumptions (another kernel, another quantity, a shift, rows from below,
// another scale), and the assumption with the fewest changes that leaves no difference is named.
#pragma once

#include <functional>
#include <optional>

#include "analysis/stored/StoredAssumption.h"

namespace umbra {

struct StoredExplanation {
  StoredAssumption assumption;
  int changes = 0;       // in which the assumption differs from the technique and kernel given
  bool isWhole = false;  // nothing is left but what the format rounds; else the most of it is gone
  double before = 0.0, after = 0.0;  // root of the mean squared difference, in the part of the map
                                     // where the difference was largest
};

// An assumption that leaves more than this part of the difference explains nothing, nor one that
// leaves more than this part of what the stored values themselves vary by: any values lie near to
// any others where the exact ones are huge.
inline constexpr double mostLeft = 0.25, mostOfSpread = 0.1;
// The standard deviation of the values that are numbers.
double spreadOf(const Image<double>& stored);

// Nothing where no assumption takes three quarters of the difference away. Calls `between` often,
// which may throw to stop the work.
std::optional<StoredExplanation> explainStored(const StoredQuestion& question,
                                               const Image<double>& stored,
                                               const std::function<void()>& between);

}  // namespace umbra
