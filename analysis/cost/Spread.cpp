#include "analysis/cost/Spread.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbra {
namespace {

double quantileOf(std::span<const double> ascending, double p) {
  const double place = p * double(ascending.size() - 1);
  const auto below = std::size_t(place);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return std::lerp(ascending[below], ascending[above], place - double(below));
}

}  // namespace

Spread spreadOf(std::span<const double> values) {
  if (values.empty()) return {};
  std::vector<double> ascending(values.begin(), values.end());
  std::sort(ascending.begin(), ascending.end());
  return {quantileOf(ascending, 0.25), quantileOf(ascending, 0.5), quantileOf(ascending, 0.75),
          ascending.size()};
}

double medianError(const Spread& spread) {
  if (spread.count == 0) return 0.0;
  return 1.57 * (spread.q3 - spread.q1) / std::sqrt(double(spread.count));
}

bool isSettled(const Spread& spread, double part) {
  return spread.count > 0 && medianError(spread) <= part * std::abs(spread.median);
}

}  // namespace umbra
