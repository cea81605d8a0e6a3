#include "analysis/cost/ParetoFront.h"

#include <algorithm>

namespace umbra {
namespace {

bool beats(const CostAndError& a, const CostAndError& b) {
  return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

}  // namespace

std::vector<std::size_t> paretoFront(std::span<const CostAndError> choices) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (std::none_of(choices.begin(), choices.end(),
                     [&](const CostAndError& other) { return beats(other, choices[i]); }))
      front.push_back(i);
  std::stable_sort(front.begin(), front.end(),
                   [&](std::size_t a, std::size_t b) { return choices[a].cost < choices[b].cost; });
  return front;
}

}  // namespace umbra
