#include "filters/core/maps/MipLevels.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace umbra {
namespace {

// The two texels of a level of `count` about `position` (texels of level 0), and the weight of the
// second. Texel centres sit at half-integers.
double mixAlong(double position, int level, int count, int (&texels)[2]) {
  const double p = std::ldexp(position, -level) - 0.5;
  const double first = std::floor(p);
  const double last = count - 1.0;
  texels[0] = int(std::clamp(first, 0.0, last));
  texels[1] = int(std::clamp(first + 1.0, 0.0, last));
  return p - first;
}

LevelRead readAt(double x, double y, int level, double weight, int levels) {
  LevelRead read;
  read.level = level;
  read.weight = weight;
  const int count = 1 << (levels - level);
  read.fx = mixAlong(x, level, count, read.x);
  read.fy = mixAlong(y, level, count, read.y);
  return read;
}

}  // namespace

int mipLevels(int width, int height) {
  return std::bit_width(unsigned(std::max(width, height) - 1));
}

std::vector<LevelRead> levelReadsOf(const ReadPoint& read, int width, int height) {
  const Footprint& footprint = read.footprint;
  const int levels = mipLevels(width, height), probes = std::max(footprint.probes, 1);
  const double length = std::hypot(footprint.x, footprint.y) / probes;
  const double lambda = length > 1.0 ? std::min(std::log2(length), double(levels)) : 0.0;
  const int level = int(lambda);
  const double next = lambda - level;
  std::vector<LevelRead> reads;
  for (int i = 0; i < probes; ++i) {
    const double along = (i + 0.5) / probes - 0.5;
    const double x = read.u * width + footprint.x * along;
    const double y = read.v * height + footprint.y * along;
    reads.push_back(readAt(x, y, level, (1.0 - next) / probes, levels));
    if (next > 0.0) reads.push_back(readAt(x, y, level + 1, next / probes, levels));
  }
  return reads;
}

}  // namespace umbra
