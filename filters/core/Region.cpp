#include "filters/core/Region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "filters/core/Error.h"

namespace umbra {
namespace {

// Taps `x0 … x0+wx.size()-1` by `y0 …`, weights the outer product of `wx` and `wy`.
void addTaps(Region& region, const DepthMap& map, int x0, int y0, const std::vector<double>& wx,
             const std::vector<double>& wy) {
  region.texels.reserve(wx.size() * wy.size());
  for (std::size_t j = 0; j < wy.size(); ++j) {
    const int y = std::clamp(y0 + int(j), 0, map.height() - 1);
    for (std::size_t i = 0; i < wx.size(); ++i) {
      // A bilinear read at a texel's centre gives its outermost taps no weight at all.
      if (wx[i] * wy[j] == 0.0) continue;
      const int x = std::clamp(x0 + int(i), 0, map.width() - 1);
      region.texels.push_back({x, y, map(x, y), wx[i] * wy[j], 0});
    }
  }
}

// `weights` convolved with the two bilinear weights (1−f, f).
std::vector<double> widened(const std::vector<double>& weights, double f) {
  std::vector<double> wide(weights.size() + 1, 0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    wide[i] += weights[i] * (1.0 - f);
    wide[i + 1] += weights[i] * f;
  }
  return wide;
}

// The texel of `size` that holds u; the far edge belongs to the last one.
int texelAt(double u, int size) {
  return u == 1.0 ? size - 1 : int(std::floor(u * size));
}

}  // namespace

Region regionAtTexel(const DepthMap& map, const Kernel& kernel, int x, int y) {
  if (x < 0 || y < 0 || x >= map.width() || y >= map.height())
    throw Error(ErrorKind::BadCommandLine, "texel " + std::to_string(x) + "," + std::to_string(y) +
                                               " is outside the " + std::to_string(map.width()) +
                                               "x" + std::to_string(map.height()) + " map");
  Region region{x, y, kernel, {}, map(x, y)};
  const std::vector<double> weights = kernel.weights();
  addTaps(region, map, x - kernel.effectiveRadius(), y - kernel.effectiveRadius(), weights,
          weights);
  return region;
}

Region regionBilinear(const DepthMap& map, const Kernel& kernel, double u, double v) {
  // Texel centres sit at half-integers.
  const double px = u * map.width() - 0.5, py = v * map.height() - 0.5;
  const int x0 = int(std::floor(px)), y0 = int(std::floor(py));
  const int nearestX = std::clamp(int(std::floor(u * map.width())), 0, map.width() - 1);
  const int nearestY = std::clamp(int(std::floor(v * map.height())), 0, map.height() - 1);
  Region region{nearestX, nearestY, kernel, {}, map(nearestX, nearestY)};
  const std::vector<double> weights = kernel.weights();
  const int r = kernel.effectiveRadius();
  addTaps(region, map, x0 - r, y0 - r, widened(weights, px - x0), widened(weights, py - y0));
  return region;
}

ReadPoint ReadPoint::atTexel(const DepthMap& map, int x, int y) {
  return {ReadFilter::Point, (x + 0.5) / map.width(), (y + 0.5) / map.height(), {}};
}

Region regionOf(const DepthMap& map, const Kernel& kernel, const ReadPoint& read) {
  if (read.filter == ReadFilter::Bilinear) return regionBilinear(map, kernel, read.u, read.v);
  return regionAtTexel(map, kernel, texelAt(read.u, map.width()), texelAt(read.v, map.height()));
}

RegionStatistics statisticsOf(const Region& region) {
  RegionStatistics s;
  s.min = std::numeric_limits<double>::infinity();
  s.max = -s.min;
  for (const RegionTexel& texel : region.texels) {
    s.mean += texel.weight * texel.depth;
    s.secondMoment += texel.weight * texel.depth * texel.depth;
    s.min = std::min(s.min, texel.depth);
    s.max = std::max(s.max, texel.depth);
  }
  for (const RegionTexel& texel : region.texels)
    s.variance += texel.weight * (texel.depth - s.mean) * (texel.depth - s.mean);
  s.mean = std::clamp(s.mean, s.min, s.max);
  const double above = s.max - s.mean;
  s.beta = above > 0.0 ? (s.mean - s.min) / above : std::numeric_limits<double>::infinity();
  return s;
}

double referenceVisibility(const Region& region, double receiver) {
  double visible = 0.0;
  for (const RegionTexel& texel : region.texels)
    visible += texel.depth >= receiver ? texel.weight : 0.0;  // adding 0 costs less than a branch
  return std::min(visible, 1.0);
}

}  // namespace umbra
