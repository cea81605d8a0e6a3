// A few combinations in which every two choices of different axes meet.
#pragma once

#include <set>
#include <tuple>
#include <vector>

namespace umbra::test {

// `sizes` says how many choices each axis has; a combination is one choice of each. Every pair of
// choices of two axes occurs in at least one combination.
inline std::vector<std::vector<int>> pairwise(const std::vector<int>& sizes) {
  using Pair = std::tuple<int, int, int, int>;  // axis, choice, later axis, choice
  const int axes = int(sizes.size());
  std::set<Pair> open;
  for (int a = 0; a < axes; ++a)
    for (int b = a + 1; b < axes; ++b)
      for (int i = 0; i < sizes[a]; ++i)
        for (int j = 0; j < sizes[b]; ++j) open.insert({a, i, b, j});
  std::vector<std::vector<int>> combinations;
  while (!open.empty()) {
    // Starts from a pair that has not met, then takes for each axis the choice that adds most new
    // pairs.
    std::vector<int> chosen(axes, -1);
    const auto [first, i, second, j] = *open.begin();
    chosen[first] = i;
    chosen[second] = j;
    for (int axis = 0; axis < axes; ++axis) {
      if (chosen[axis] >= 0) continue;
      int best = 0, most = -1;
      for (int choice = 0; choice < sizes[axis]; ++choice) {
        int closed = 0;
        for (int other = 0; other < axes; ++other)
          if (chosen[other] >= 0)
            closed += axis < other ? open.count({axis, choice, other, chosen[other]})
                                   : open.count({other, chosen[other], axis, choice});
        if (closed > most) std::tie(best, most) = std::tuple(choice, closed);
      }
      chosen[axis] = best;
    }
    for (int a = 0; a < axes; ++a)
      for (int b = a + 1; b < axes; ++b) open.erase({a, chosen[a], b, chosen[b]});
    combinations.push_back(chosen);
  }
  return combinations;
}

}  // namespace umbra::test
