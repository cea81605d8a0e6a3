#include "ui/widgets/forms/SliderScale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace umbra {
namespace {

// Rounds through text, since 0.3 is not a whole multiple of 0.1 in binary.
double roundedTo(double value, const char* format, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, digits, value);
  return std::strtod(buffer, nullptr);
}

}  // namespace

int SliderScale::positions() const {
  return whole ? int(std::lround(high - low)) : 1000;
}

int SliderScale::positionOf(double value) const {
  const double inside = std::clamp(value, low, high);
  if (!(high > low) || inside <= low) return 0;
  const double share = isLogarithmic() ? std::log(std::max(inside, smallest()) / smallest()) /
                                             std::log(high / smallest())
                                       : (inside - low) / (high - low);
  return int(std::lround(share * positions()));
}

double SliderScale::valueAt(int position) const {
  if (position <= 0) return low;
  if (position >= positions()) return high;
  if (whole) return low + position;
  const double share = double(position) / positions();
  if (isLogarithmic())
    return std::clamp(roundedTo(smallest() * std::pow(high / smallest(), share), "%.*e", 2), low,
                      high);
  const int digits = std::max(0, int(std::ceil(-std::log10((high - low) / positions()))));
  return std::clamp(roundedTo(low + share * (high - low), "%.*f", digits), low, high);
}

double SliderScale::stepped(double value, int steps) const {
  double next = value + steps;
  if (isLogarithmic() && !whole) {
    next = roundedTo(std::max(value, smallest()) * std::pow(10.0, steps * 0.1), "%.*e", 2);
    if (next < smallest()) next = low;
  } else if (!whole) {
    const int digits = std::max(0, int(std::ceil(-std::log10((high - low) / 100.0))));
    next = value + steps * std::pow(10.0, -digits);
    next = roundedTo(next, "%.*f", digits + 2);
  }
  return std::clamp(next, low, high);
}

}  // namespace umbra
