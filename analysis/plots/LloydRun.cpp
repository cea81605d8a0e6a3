#include "analysis/plots/LloydRun.h"

#include <utility>

namespace umbra {

LloydRun::LloydRun(std::shared_ptr<const SortedSamples> samples, std::vector<double> start)
    : samples_(std::move(samples)), relaxation_({.splits = int(start.size()), .start = start}) {
  const double cost = samples_->cost(start);
  frames_.push_back({std::move(start), cost, 0});
}

std::vector<double> LloydRun::costs() const {
  std::vector<double> costs;
  for (const LloydFrame& frame : frames_) costs.push_back(frame.cost);
  return costs;
}

bool LloydRun::advance() {
  const std::vector<double> before = frames_.back().splits;
  if (before.empty() || samples_->empty()) return false;
  // A teleport takes two rounds of sums, and the last iteration only finds that nothing moves.
  while (!relaxation_.settled() && relaxation_.result().splits == before)
    relaxation_.take(samples_->clusters(relaxation_.ends()));
  const LloydResult& now = relaxation_.result();
  if (now.splits == before) return false;
  frames_.push_back({now.splits, samples_->cost(now.splits), now.teleports});
  return true;
}

}  // namespace umbra
