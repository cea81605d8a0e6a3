// A stored channel checked: how far it is from the exact one, where, and what that looks like.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "analysis/stored/StoredChannel.h"
#include "analysis/stored/StoredFit.h"

namespace umbra {

struct StoredFinding {
  StorageFormat format = StorageFormat::Float;  // that `difference` counts in
  StorageFormat heldBy = StorageFormat::Float;  // the coarsest that holds all stored values
  StoredDifference difference;                  // from the exact channel
  bool agrees = false;                          // to what `heldBy` rounds
  bool onlyAtEdges = false;  // all that differs lies within the kernel's reach of the map's edge
  std::optional<StoredExplanation> explanation;  // of a channel that does not agree
  std::optional<StoredDifference> left;          // from the explanation, over the whole map
  std::string text;                              // all of it in sentences
};

// `stored` is one channel of the map's size. Calls `between` often, which may throw to stop the
// work.
StoredFinding checkStored(const StoredQuestion& question, const Image<double>& stored,
                          const std::function<void()>& between);

}  // namespace umbra
