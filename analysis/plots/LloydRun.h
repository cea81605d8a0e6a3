// Lloyd's relaxation, one iteration at a time, with a record of all iterations so far.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "filters/core/technique/SortedSamples.h"

namespace umbra {

// The state that an iteration left.
struct LloydFrame {
  std::vector<double> splits;  // ascending depths; μ + σ may lie a little beyond 1
  double cost = 0.0;           // of these splits, depth²
  int teleports = 0;           // all teleports so far
};

class LloydRun {
 public:
  // Frame 0 is `start`: ascending, with at least one value if the run is to advance.
  LloydRun(std::shared_ptr<const SortedSamples> samples, std::vector<double> start);

  const std::vector<LloydFrame>& frames() const { return frames_; }
  std::vector<double> costs() const;
  // Does one iteration that moves every split (Lauritzen 2008, §4.1.3), with a teleport where a
  // split has no samples. Returns false, and adds no frame, where nothing moves any more.
  bool advance();

 private:
  std::shared_ptr<const SortedSamples> samples_;
  Relaxation relaxation_;
  std::vector<LloydFrame> frames_;
};

}  // namespace umbra
