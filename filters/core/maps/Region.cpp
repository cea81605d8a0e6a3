#include "filters/core/maps/Region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "filters/core/maps/MipLevels.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

// Adds every sample of texel (x, y); together they have `weight`.
void addTexel(Region& region, const DepthMap& map, int x, int y, double weight) {
  for (int sample = 0; sample < map.channels(); ++sample)
    region.texels.push_back({x, y, map(x, y, sample), weight / map.channels(), 0});
}

// Adds the taps `x0 … x0+wx.size()-1` by `y0 …`; their weights are the outer product of `wx` and
// `wy`.
void addTaps(Region& region, const DepthMap& map, int x0, int y0, const std::vector<double>& wx,
             const std::vector<double>& wy) {
  region.texels.reserve(wx.size() * wy.size() * map.channels());
  for (std::size_t j = 0; j < wy.size(); ++j) {
    const int y = std::clamp(y0 + int(j), 0, map.height() - 1);
    for (std::size_t i = 0; i < wx.size(); ++i) {
      // A bilinear read at a texel's centre gives its outermost taps no weight at all.
      if (wx[i] * wy[j] == 0.0) continue;
      addTexel(region, map, std::clamp(x0 + int(i), 0, map.width() - 1), y, wx[i] * wy[j]);
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

// A region without taps. The texel nearest to (u, v) is the one that holds it.
Region emptyRegion(const DepthMap& map, const Kernel& kernel, double u, double v) {
  const int x = std::clamp(int(std::floor(u * map.width())), 0, map.width() - 1);
  const int y = std::clamp(int(std::floor(v * map.height())), 0, map.height() - 1);
  const int reach = kernel.effectiveRadius();
  return {x, y, kernel, {}, map(x, y), map.channels(), reach, reach};
}

// Weights along one axis, from texel `first` on, all inside the map.
struct AxisWeights {
  int first = 0;
  std::vector<double> weights;

  int end() const { return first + int(weights.size()); }
};

// A bilinear read of a mip level, as weights of the depth map's texels: the kernel is applied about
// every prefiltered texel of the two blocks. Both the blocks and the kernel repeat the map's edge.
AxisWeights levelWeights(const int (&texels)[2], double mix, int level, int size,
                         const std::vector<double>& kernel) {
  const int r = int(kernel.size()) / 2, block = 1 << level;
  const auto inside = [size](int texel) { return std::clamp(texel, 0, size - 1); };
  const int first = inside(texels[0] * block), last = inside(texels[1] * block + block - 1);
  std::vector<double> prefiltered(last - first + 1, 0.0);
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < block; ++i)
      prefiltered[inside(texels[side] * block + i) - first] += (side ? mix : 1.0 - mix) / block;
  AxisWeights axis{inside(first - r), {}};
  axis.weights.assign(inside(last + r) - axis.first + 1, 0.0);
  for (int i = 0; i < int(prefiltered.size()); ++i)
    for (int k = -r; k <= r; ++k)
      axis.weights[inside(first + i + k) - axis.first] += prefiltered[i] * kernel[k + r];
  return axis;
}

struct Rectangle {
  AxisWeights x, y;
  double weight = 1.0;
};

// Adds up the weights of all rectangles, so that each texel occurs once.
void addRectangles(Region& region, const DepthMap& map, const std::vector<Rectangle>& rectangles) {
  int left = map.width(), right = 0, top = map.height(), bottom = 0;
  for (const Rectangle& r : rectangles) {
    left = std::min(left, r.x.first);
    right = std::max(right, r.x.end());
    top = std::min(top, r.y.first);
    bottom = std::max(bottom, r.y.end());
  }
  Image<double> weights(right - left, bottom - top);
  for (const Rectangle& r : rectangles)
    for (int y = r.y.first; y < r.y.end(); ++y)
      for (int x = r.x.first; x < r.x.end(); ++x)
        weights(x - left, y - top) +=
            r.weight * r.x.weights[x - r.x.first] * r.y.weights[y - r.y.first];
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      if (weights(x - left, y - top) > 0.0) addTexel(region, map, x, y, weights(x - left, y - top));
}

Region regionOfLevels(const DepthMap& map, const Kernel& kernel, const ReadPoint& read) {
  const std::vector<double> weights = kernel.weights();
  std::vector<Rectangle> rectangles;
  for (const LevelRead& level : levelReadsOf(read, map.width(), map.height()))
    rectangles.push_back({levelWeights(level.x, level.fx, level.level, map.width(), weights),
                          levelWeights(level.y, level.fy, level.level, map.height(), weights),
                          level.weight});
  Region region = emptyRegion(map, kernel, read.u, read.v);
  addRectangles(region, map, rectangles);
  return region;
}

// The texels of which a box along one axis covers a part, each with its share of the box.
AxisWeights boxWeights(double middle, double width, int size) {
  const double low = middle - 0.5 * width, high = middle + 0.5 * width;
  const auto inside = [size](double texel) { return int(std::clamp(texel, 0.0, size - 1.0)); };
  AxisWeights axis{inside(std::floor(low)), {}};
  axis.weights.assign(inside(std::ceil(high) - 1.0) - axis.first + 1, 0.0);
  for (double texel = std::floor(low); texel < high; texel += 1.0) {
    const double covered = std::min(high, texel + 1.0) - std::max(low, texel);
    axis.weights[inside(texel) - axis.first] += covered / width;
  }
  return axis;
}

Region regionOfBox(const DepthMap& map, const Kernel& kernel, const ReadPoint& read) {
  const double width = std::max(read.footprint.x, 1.0), height = std::max(read.footprint.y, 1.0);
  Region region = emptyRegion(map, kernel, read.u, read.v);
  region.reachX = int(0.5 * (width - 1.0));
  region.reachY = int(0.5 * (height - 1.0));
  addRectangles(region, map,
                {{boxWeights(read.u * map.width(), width, map.width()),
                  boxWeights(read.v * map.height(), height, map.height())}});
  return region;
}

}  // namespace

Region regionAtTexel(const DepthMap& map, const Kernel& kernel, int x, int y) {
  if (x < 0 || y < 0 || x >= map.width() || y >= map.height())
    throw Error(ErrorKind::BadCommandLine, "texel " + std::to_string(x) + "," + std::to_string(y) +
                                               " is outside the " + std::to_string(map.width()) +
                                               "x" + std::to_string(map.height()) + " map");
  const int r = kernel.effectiveRadius();
  Region region{x, y, kernel, {}, map(x, y), map.channels(), r, r};
  const std::vector<double> weights = kernel.weights();
  addTaps(region, map, x - r, y - r, weights, weights);
  return region;
}

Region regionBilinear(const DepthMap& map, const Kernel& kernel, double u, double v) {
  // Texel centres sit at half-integers.
  const double px = u * map.width() - 0.5, py = v * map.height() - 0.5;
  const int x0 = int(std::floor(px)), y0 = int(std::floor(py));
  Region region = emptyRegion(map, kernel, u, v);
  const std::vector<double> weights = kernel.weights();
  const int r = kernel.effectiveRadius();
  addTaps(region, map, x0 - r, y0 - r, widened(weights, px - x0), widened(weights, py - y0));
  return region;
}

ReadPoint ReadPoint::atTexel(const DepthMap& map, int x, int y) {
  return {ReadFilter::Point, (x + 0.5) / map.width(), (y + 0.5) / map.height(), {}};
}

Region regionOf(const DepthMap& map, const Kernel& kernel, const ReadPoint& read) {
  switch (read.filter) {
    case ReadFilter::Bilinear:
      return regionBilinear(map, kernel, read.u, read.v);
    case ReadFilter::Trilinear:
    case ReadFilter::Anisotropic:
      return regionOfLevels(map, kernel, read);
    case ReadFilter::SummedArea:
      return regionOfBox(map, kernel, read);
    case ReadFilter::Point:
      break;
  }
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
