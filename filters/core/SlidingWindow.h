// Windowed reductions along one line of texels, edges repeated. `line` holds n values, in and out.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbra {
namespace detail {

// `line` with its first and last value repeated `r` times at either end.
inline std::vector<double> padded(const std::vector<double>& line, int r) {
  std::vector<double> wide(line.size() + 2 * std::size_t(r), line.front());
  std::copy(line.begin(), line.end(), wide.begin() + r);
  std::fill(wide.end() - r, wide.end(), line.back());
  return wide;
}

}  // namespace detail

// Mean of 2r+1 values by a running sum. The sum is compensated (Neumaier 1974), so that a large
// value that has left the window leaves no rounding error behind.
inline void slidingMean(std::vector<double>& line, int r) {
  const std::vector<double> wide = detail::padded(line, r);
  double sum = 0.0, lost = 0.0;
  const auto add = [&](double value) {
    const double next = sum + value;
    lost += std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
    sum = next;
  };
  for (int i = 0; i < 2 * r; ++i) add(wide[i]);
  for (std::size_t i = 0; i < line.size(); ++i) {
    add(wide[i + 2 * r]);
    line[i] = (sum + lost) / (2 * r + 1);
    add(-wide[i]);
  }
}

// Weighted mean; `weights` has 2r+1 values.
inline void slidingWeightedMean(std::vector<double>& line, const std::vector<double>& weights) {
  const std::vector<double> wide = detail::padded(line, int(weights.size()) / 2);
  for (std::size_t i = 0; i < line.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * wide[i + k];
    line[i] = sum;
  }
}

// Minimum or maximum of 2r+1 values, by van Herk's and Gil & Werman's method: blocks as long as
// the window, each with its running extreme from the left and from the right, so that every
// window is the better of two values.
template <class Better>
void slidingExtreme(std::vector<double>& line, int r, Better better) {
  const std::size_t window = 2 * std::size_t(r) + 1;
  std::vector<double> fromLeft = detail::padded(line, r);
  fromLeft.resize((fromLeft.size() + window - 1) / window * window, fromLeft.back());
  std::vector<double> fromRight = fromLeft;
  for (std::size_t i = 1; i < fromLeft.size(); ++i) {
    if (i % window != 0) fromLeft[i] = better(fromLeft[i], fromLeft[i - 1]);
    const std::size_t j = fromLeft.size() - 1 - i;
    if ((j + 1) % window != 0) fromRight[j] = better(fromRight[j], fromRight[j + 1]);
  }
  for (std::size_t i = 0; i < line.size(); ++i)
    line[i] = better(fromRight[i], fromLeft[i + window - 1]);
}

}  // namespace umbra
