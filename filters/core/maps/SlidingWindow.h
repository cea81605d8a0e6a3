// Windowed reductions along one line of texels, edges repeated. Each changes the n values of `line`
// in place.
#pragma once

#include <algorithm>
#include <cstddef>
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

// Weighted mean; `weights` has 2r+1 values.
inline void slidingWeightedMean(std::vector<double>& line, const std::vector<double>& weights) {
  const std::vector<double> wide = detail::padded(line, int(weights.size()) / 2);
  for (std::size_t i = 0; i < line.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * wide[i + k];
    line[i] = sum;
  }
}

// Any associative reduction of 2r+1 values, by van Herk's and Gil & Werman's method: blocks as long
// as the window, each with its running result from the left and from the right, so that every
// window is the end of one block and the beginning of the next. Three operations a texel, whatever
// the radius.
template <class Combine>
void slidingReduction(std::vector<double>& line, int r, Combine combine) {
  const std::size_t window = 2 * std::size_t(r) + 1;
  std::vector<double> fromLeft = detail::padded(line, r);
  fromLeft.resize((fromLeft.size() + window - 1) / window * window, fromLeft.back());
  std::vector<double> fromRight = fromLeft;
  for (std::size_t i = 1; i < fromLeft.size(); ++i) {
    if (i % window != 0) fromLeft[i] = combine(fromLeft[i - 1], fromLeft[i]);
    const std::size_t j = fromLeft.size() - 1 - i;
    if ((j + 1) % window != 0) fromRight[j] = combine(fromRight[j], fromRight[j + 1]);
  }
  for (std::size_t i = 0; i < line.size(); ++i)
    line[i] = i % window == 0 ? fromRight[i] : combine(fromRight[i], fromLeft[i + window - 1]);
}

// Mean of 2r+1 values. Unlike a running sum nothing is ever subtracted, so that positive values,
// such as exponentials forty orders of magnitude apart, keep full relative accuracy.
inline void slidingMean(std::vector<double>& line, int r) {
  slidingReduction(line, r, [](double a, double b) { return a + b; });
  for (double& value : line) value /= 2 * r + 1;
}

inline void slidingMinimum(std::vector<double>& line, int r) {
  slidingReduction(line, r, [](double a, double b) { return std::min(a, b); });
}

inline void slidingMaximum(std::vector<double>& line, int r) {
  slidingReduction(line, r, [](double a, double b) { return std::max(a, b); });
}

}  // namespace umbra
