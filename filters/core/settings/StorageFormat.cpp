#include "filters/core/settings/StorageFormat.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbra {
namespace {

double quantised(double value, double low, double high, double steps) {
  const double fraction = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return low + (high - low) * std::nearbyint(fraction * steps) / steps;
}

// A half has 11 significant bits, is subnormal below 2⁻¹⁴ and overflows to infinity. The value is
// rounded once from double, since rounding by way of float could round twice.
double toHalf(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  int exponent = 0;
  std::frexp(value, &exponent);  // |value| in [2^(e−1), 2^e)
  const double step = std::ldexp(1.0, std::max(exponent, -13) - 11);
  const double rounded = std::nearbyint(value / step) * step;
  return std::abs(rounded) > 65504.0 ? std::copysign(std::numeric_limits<double>::infinity(), value)
                                     : rounded;
}

}  // namespace

double stored(double value, StorageFormat format, double low, double high) {
  switch (format) {
    case StorageFormat::Unorm8:
      return quantised(value, low, high, 255.0);
    case StorageFormat::Unorm16:
      return quantised(value, low, high, 65535.0);
    case StorageFormat::Half:
      return toHalf(value);
    case StorageFormat::Float:
      return double(float(value));
    case StorageFormat::Double:
      break;
  }
  return value;
}

double largestOf(StorageFormat format) {
  switch (format) {
    case StorageFormat::Unorm8:
    case StorageFormat::Unorm16:
      return 1.0;
    case StorageFormat::Half:
      return 65504.0;
    case StorageFormat::Float:
      return std::numeric_limits<float>::max();
    case StorageFormat::Double:
      break;
  }
  return std::numeric_limits<double>::max();
}

double unitRoundoff(StorageFormat format) {
  switch (format) {
    case StorageFormat::Unorm8:
      return 0.5 / 255.0;
    case StorageFormat::Unorm16:
      return 0.5 / 65535.0;
    case StorageFormat::Half:
      return std::ldexp(1.0, -11);
    case StorageFormat::Float:
      return std::ldexp(1.0, -24);
    case StorageFormat::Double:
      break;
  }
  return std::ldexp(1.0, -53);
}

bool isNormalised(StorageFormat format) {
  return format == StorageFormat::Unorm8 || format == StorageFormat::Unorm16;
}

int bytesOf(StorageFormat format) {
  switch (format) {
    case StorageFormat::Unorm8:
      return 1;
    case StorageFormat::Unorm16:
    case StorageFormat::Half:
      return 2;
    case StorageFormat::Float:
      return 4;
    case StorageFormat::Double:
      break;
  }
  return 8;
}

std::string_view nameOf(StorageFormat format) {
  switch (format) {
    case StorageFormat::Unorm8:
      return "unorm8";
    case StorageFormat::Unorm16:
      return "unorm16";
    case StorageFormat::Half:
      return "half";
    case StorageFormat::Float:
      return "float";
    case StorageFormat::Double:
      return "double";
  }
  return "";
}

}  // namespace umbra
