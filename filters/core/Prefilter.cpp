#include "filters/core/Prefilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "filters/core/SlidingWindow.h"

namespace umbra {
namespace {

double storedIn(const Channel& channel, double value, StorageFormat format) {
  return stored(value, format, channel.low, channel.high);
}

// One line of texels, reduced in place.
void reduceLine(std::vector<double>& line, Reduction reduction, const Kernel& kernel,
                const std::vector<double>& weights) {
  const int r = kernel.effectiveRadius();
  switch (reduction) {
    case Reduction::Mean:
      if (kernel.shape == KernelShape::Box)
        slidingMean(line, r);
      else
        slidingWeightedMean(line, weights);
      break;
    case Reduction::Min:
      slidingMinimum(line, r);
      break;
    case Reduction::Max:
      slidingMaximum(line, r);
      break;
  }
}

}  // namespace

Image<double> encodeMap(const DepthMap& map, const Technique& technique, StorageFormat format) {
  const std::vector<Channel> layout = technique.channels();
  Image<double> channels(map.width(), map.height(), int(layout.size()));
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) technique.encode(map(x, y), channels.pixel(x, y));
  storeMap(channels, layout, format);
  return channels;
}

Image<double> reduceMap(const Image<double>& channels, std::span<const Channel> layout,
                        const Kernel& kernel) {
  Image<double> reduced = channels;
  if (kernel.effectiveRadius() == 0) return reduced;
  const std::vector<double> weights = kernel.weights();
  std::vector<double> line;
  for (std::size_t c = 0; c < layout.size(); ++c) {
    line.resize(reduced.width());
    for (int y = 0; y < reduced.height(); ++y) {
      for (int x = 0; x < reduced.width(); ++x) line[x] = reduced(x, y, int(c));
      reduceLine(line, layout[c].reduction, kernel, weights);
      for (int x = 0; x < reduced.width(); ++x) reduced(x, y, int(c)) = line[x];
    }
    line.resize(reduced.height());
    for (int x = 0; x < reduced.width(); ++x) {
      for (int y = 0; y < reduced.height(); ++y) line[y] = reduced(x, y, int(c));
      reduceLine(line, layout[c].reduction, kernel, weights);
      for (int y = 0; y < reduced.height(); ++y) reduced(x, y, int(c)) = line[y];
    }
  }
  return reduced;
}

void storeMap(Image<double>& channels, std::span<const Channel> layout, StorageFormat format) {
  if (format == StorageFormat::Double) return;
  for (int y = 0; y < channels.height(); ++y)
    for (int x = 0; x < channels.width(); ++x)
      for (std::size_t c = 0; c < layout.size(); ++c)
        channels(x, y, int(c)) = storedIn(layout[c], channels(x, y, int(c)), format);
}

Image<double> prefilteredMap(const DepthMap& map, const Technique& technique, const Kernel& kernel,
                             StorageFormat format) {
  const std::vector<Channel> layout = technique.channels();
  Image<double> reduced = reduceMap(encodeMap(map, technique, format), layout, kernel);
  storeMap(reduced, layout, format);
  return reduced;
}

std::vector<double> prefilteredRegion(const Region& region, const Technique& technique,
                                      StorageFormat format) {
  const std::vector<Channel> layout = technique.channels();
  std::vector<double> texel(layout.size()), reduced(layout.size(), 0.0);
  // A four-moment bound divides by differences of these sums that are 10⁻⁷ of them: plain sums
  // would leave it nine digits.
  std::vector<long double> sums(layout.size(), 0.0L);
  bool first = true;
  for (const RegionTexel& tap : region.texels) {
    technique.encode(tap.depth, texel);
    for (std::size_t c = 0; c < layout.size(); ++c) {
      const double value = storedIn(layout[c], texel[c], format);
      switch (layout[c].reduction) {
        case Reduction::Mean:
          sums[c] += static_cast<long double>(tap.weight) * value;
          break;
        case Reduction::Min:
          reduced[c] = first ? value : std::min(reduced[c], value);
          break;
        case Reduction::Max:
          reduced[c] = first ? value : std::max(reduced[c], value);
          break;
      }
    }
    first = false;
  }
  for (std::size_t c = 0; c < layout.size(); ++c) {
    if (layout[c].reduction == Reduction::Mean) reduced[c] = double(sums[c]);
    reduced[c] = storedIn(layout[c], reduced[c], format);
  }
  return reduced;
}

std::vector<double> readBilinear(const DepthMap& map, const Technique& technique,
                                 const Kernel& kernel, StorageFormat format, double u, double v) {
  // Texel centres sit at half-integers.
  const double px = u * map.width() - 0.5, py = v * map.height() - 0.5;
  const double fx = px - std::floor(px), fy = py - std::floor(py);
  std::vector<double> mixed;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const int x = std::clamp(int(std::floor(px)) + i, 0, map.width() - 1);
      const int y = std::clamp(int(std::floor(py)) + j, 0, map.height() - 1);
      const double weight = (i ? fx : 1.0 - fx) * (j ? fy : 1.0 - fy);
      const std::vector<double> texel =
          prefilteredRegion(regionAtTexel(map, kernel, x, y), technique, format);
      mixed.resize(texel.size(), 0.0);
      for (std::size_t c = 0; c < texel.size(); ++c) mixed[c] += weight * texel[c];
    }
  }
  return mixed;
}

std::vector<double> readChannels(const DepthMap& map, const Technique& technique,
                                 const Kernel& kernel, StorageFormat format,
                                 const ReadPoint& read) {
  if (read.filter == ReadFilter::Bilinear)
    return readBilinear(map, technique, kernel, format, read.u, read.v);
  return prefilteredRegion(regionOf(map, kernel, read), technique, format);
}

}  // namespace umbra
