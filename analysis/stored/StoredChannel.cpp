#include "analysis/stored/StoredChannel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbra {
namespace {

bool holdsAll(const Image<double>& image, const Channel& channel, StorageFormat format) {
  return std::all_of(image.values().begin(), image.values().end(), [&](double value) {
    if (!std::isfinite(value)) return true;
    const double kept = umbra::stored(value, format, channel.low, channel.high);
    // A file keeps a fraction as a float, which rounds it once more.
    return isNormalised(format) ? float(kept) == float(value) : kept == value;
  });
}

// Few different values fit into many formats by chance.
bool hasManyValues(const Image<double>& image) {
  constexpr std::size_t many = 16;
  std::vector<double> seen;
  for (double value : image.values()) {
    if (!std::isfinite(value) || std::find(seen.begin(), seen.end(), value) != seen.end()) continue;
    seen.push_back(value);
    if (seen.size() == many) return true;
  }
  return false;
}

}  // namespace

StorageFormat formatThatHolds(const Image<double>& stored, const Channel& channel,
                              StorageFormat declared) {
  if (!hasManyValues(stored)) return declared;
  for (StorageFormat format :
       {StorageFormat::Unorm8, StorageFormat::Unorm16, StorageFormat::Half, StorageFormat::Float})
    if (format < declared && holdsAll(stored, channel, format)) return format;
  return declared;
}

StoredDifference storedDifference(const StoredExpectation& expected, const Image<double>& stored,
                                  int reach) {
  StoredDifference found;
  const int width = stored.width(), height = stored.height();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double right = expected.values(x, y), value = stored(x, y);
      if (!std::isfinite(value)) {
        ++found.notFinite;
        continue;
      }
      const double difference = std::abs(value - right), units = difference / expected.unit(x, y);
      if (units > found.largestUnits || found.texels == 0) {
        found.largestUnits = units;
        found.x = x, found.y = y;
        found.expected = right, found.stored = value;
      }
      ++found.texels;
      found.largest = std::max(found.largest, difference);
      found.mean += difference;
      found.meanUnits += units;
      if (difference <= expected.allowance(x, y)) continue;
      ++found.beyond;
      found.beyondInside += x >= reach && y >= reach && x + reach < width && y + reach < height;
    }
  const double count = double(std::max<std::size_t>(found.texels, 1));
  found.mean /= count;
  found.meanUnits /= count;
  return found;
}

}  // namespace umbra
