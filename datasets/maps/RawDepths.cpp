#include "datasets/maps/RawDepths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/core/support/InputFile.h"

namespace umbra {
namespace {

// What lies between an end and its neighbour is this many times as wide as all that lies within.
constexpr double farAbove = 10.0;
// A single other value has no width to compare with: magnitudes must differ by more then.
constexpr double farAboveOne = 100.0;
// Zeros that are apart are this part of the texels, and of the span, at least.
constexpr double shareOfZeros = 0.01, gapOfZeros = 0.02;

// Takes a value into the end that is the smallest of `sign` times the values.
void take(RawDepths::End& end, double value, double sign) {
  if (end.texels == 0 || sign * value < sign * end.value) {
    end.next = end.texels == 0 ? value : end.value;
    end.value = value;
    end.texels = 1;
  } else if (value == end.value) {
    ++end.texels;
  } else if (end.next == end.value || sign * value < sign * end.next) {
    end.next = value;
  }
}

void count(RawDepths& raw, double value) {
  if (!std::isfinite(value)) {
    ++(std::isnan(value) ? raw.notNumbers : value > 0.0 ? raw.plusInfinite : raw.minusInfinite);
    return;
  }
  ++raw.finite;
  raw.zeros += value == 0.0;
  raw.ones += value == 1.0;
  raw.inLowestTenth += value > 0.0 && value <= 0.1;
  raw.inHighestTenth += value >= 0.9 && value < 1.0;
  take(raw.lowest, value, 1.0);
  take(raw.highest, value, -1.0);
}

// A largest value far above all others, such as 1e10; a single negative value, such as −1; zeros
// below distances that begin well above them.
void findEndsApart(RawDepths& raw) {
  RawDepths::End &lowest = raw.lowest, &highest = raw.highest;
  const double gap = highest.value - highest.next, within = highest.next - lowest.next;
  highest.apart = highest.value > 1.0 &&
                  (within > 0.0 ? gap > farAbove * std::max(within, std::abs(highest.next))
                                : gap > farAboveOne * std::abs(highest.next));
  const double top = highest.apart ? highest.next : highest.value;
  if (lowest.value < 0.0) lowest.apart = lowest.next >= 0.0;
  if (lowest.value == 0.0)
    lowest.apart = top > 1.0 && top > lowest.next && lowest.next > gapOfZeros * top &&
                   double(lowest.texels) >= shareOfZeros * double(raw.finite);
  const bool nothingLeft = lowest.apart && !(lowest.next <= top);
  if (nothingLeft) lowest.apart = false;
  raw.low = lowest.apart ? lowest.next : lowest.value;
  raw.high = top;
}

void fillBins(RawDepths& raw, double value) {
  if (!(value >= raw.low && value <= raw.high)) return;
  const double width = raw.high - raw.low;
  const double place = width > 0.0 ? (value - raw.low) / width * RawDepths::bins : 0.0;
  ++raw.counts[std::size_t(std::min(int(place), RawDepths::bins - 1))];
}

}  // namespace

RawDepths readRawDepths(const std::filesystem::path& file, const std::string& channel) {
  checkInput(file);
  const RasterReader named = rasterReaderOf(file), read = named ? named : readExr;
  RawDepths raw;
  raw.channels = rasterChannels(file);
  read(file, channel,
       {[&](const RasterInfo& info) { raw.info = info; },
        [&](int, std::span<const double> row) {
          for (double value : row) count(raw, value);
        }});
  raw.counts.assign(std::size_t(RawDepths::bins), 0);
  if (raw.finite == 0) return raw;
  findEndsApart(raw);
  read(file, channel,
       {[](const RasterInfo&) {},
        [&](int, std::span<const double> row) {
          for (double value : row) fillBins(raw, value);
        }});
  return raw;
}

}  // namespace umbra
