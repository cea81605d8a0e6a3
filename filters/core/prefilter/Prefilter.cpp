#include "filters/core/prefilter/Prefilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "filters/core/maps/SlidingWindow.h"

namespace umbra {
namespace {

double storedIn(const Channel& channel, double value, StorageFormat format) {
  return stored(value, format, channel.low, channel.high);
}

// Reduces several values of one channel to one, without rounding.
void gather(const Channel& channel, double& sum, double value, bool first) {
  switch (channel.reduction) {
    case Reduction::Mean:
      sum = first ? value : sum + value;
      break;
    case Reduction::Min:
      sum = first ? value : std::min(sum, value);
      break;
    case Reduction::Max:
      sum = first ? value : std::max(sum, value);
      break;
  }
}

// Reduces one line of texels in place.
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

void encodeTexel(std::span<const double> samples, const Technique& technique,
                 std::span<const Channel> layout, std::span<double> encoded) {
  technique.encode(samples[0], encoded);
  if (samples.size() == 1) return;
  std::vector<double> sample(layout.size());
  for (std::size_t s = 1; s < samples.size(); ++s) {
    technique.encode(samples[s], sample);
    for (std::size_t c = 0; c < layout.size(); ++c) gather(layout[c], encoded[c], sample[c], false);
  }
  for (std::size_t c = 0; c < layout.size(); ++c)
    if (layout[c].reduction == Reduction::Mean) encoded[c] /= double(samples.size());
}

Image<double> encodeMap(const DepthMap& map, const Technique& technique, StorageFormat format) {
  const std::vector<Channel> layout = technique.channels();
  Image<double> channels(map.width(), map.height(), int(layout.size()));
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      encodeTexel(map.pixel(x, y), technique, layout, channels.pixel(x, y));
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
  std::vector<double> depths(region.samples);
  for (std::size_t i = 0; i < region.texels.size(); i += depths.size()) {
    for (std::size_t sample = 0; sample < depths.size(); ++sample)
      depths[sample] = region.texels[i + sample].depth;
    const double weight = region.texels[i].weight * double(depths.size());
    encodeTexel(depths, technique, layout, texel);
    for (std::size_t c = 0; c < layout.size(); ++c) {
      const double value = storedIn(layout[c], texel[c], format);
      if (layout[c].reduction == Reduction::Mean)
        sums[c] += static_cast<long double>(weight) * value;
      else
        gather(layout[c], reduced[c], value, i == 0);
    }
  }
  for (std::size_t c = 0; c < layout.size(); ++c) {
    if (layout[c].reduction == Reduction::Mean) reduced[c] = double(sums[c]);
    reduced[c] = storedIn(layout[c], reduced[c], format);
  }
  return reduced;
}

}  // namespace umbra
