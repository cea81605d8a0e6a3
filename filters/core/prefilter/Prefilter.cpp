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

// Reduces one row of texels in place.
void reduceRow(std::vector<double>& row, Reduction reduction, const Kernel& kernel,
               const std::vector<double>& weights) {
  const int r = kernel.effectiveRadius();
  switch (reduction) {
    case Reduction::Mean:
      if (kernel.shape == KernelShape::Box)
        slidingMean(row, r);
      else
        slidingWeightedMean(row, weights);
      break;
    case Reduction::Min:
      slidingMinimum(row, r);
      break;
    case Reduction::Max:
      slidingMaximum(row, r);
      break;
  }
}

// One channel of some rows of a map.
class Plane {
 public:
  Plane(int width, int rows) : width_(std::size_t(width)), values_(width_ * std::size_t(rows)) {}

  std::span<double> row(int y) {
    return std::span(values_).subspan(width_ * std::size_t(y), width_);
  }
  std::span<const double> row(int y) const {
    return std::span(values_).subspan(width_ * std::size_t(y), width_);
  }

 private:
  std::size_t width_;
  std::vector<double> values_;
};

// Reduces the columns of one plane after another: the same sums as along a row, but a row at a
// time, so that memory is read in its order and the compiler uses vectors. Edge rows repeat. What
// it works in is allocated once.
class ColumnReduction {
 public:
  // The plane holds the rows `known` of a map, all that the kernel reaches from the wanted `rows`.
  ColumnReduction(int width, const Rows& known, const Rows& rows, int radius)
      : known_(known),
        rows_(rows),
        radius_(radius),
        result_(width, rows.count),
        fromLeft_(width, rows.count + 2 * radius),
        fromRight_(width, rows.count + 2 * radius),
        right_(std::size_t(width), 0.0) {}

  // The result is valid until the next call.
  const Plane& run(const Plane& plane, Reduction reduction, const Kernel& kernel,
                   const std::vector<double>& weights) {
    if (reduction == Reduction::Min)
      combine(plane, [](double a, double b) { return std::min(a, b); });
    else if (reduction == Reduction::Max)
      combine(plane, [](double a, double b) { return std::max(a, b); });
    else if (kernel.shape != KernelShape::Box)
      weigh(plane, weights);
    else
      average(plane);
    return result_;
  }

 private:
  // Row `i` of the window of the first row that is wanted. The map's edge rows repeat; of rows that
  // nobody needs the last known one stands in.
  std::span<const double> source(const Plane& plane, int i) const {
    return plane.row(std::clamp(rows_.first + i - radius_ - known_.first, 0, known_.count - 1));
  }

  void average(const Plane& plane) {
    combine(plane, [](double a, double b) { return a + b; });
    for (int y = 0; y < rows_.count; ++y)
      for (double& value : result_.row(y)) value /= 2 * radius_ + 1;
  }

  void weigh(const Plane& plane, const std::vector<double>& weights) {
    for (int y = 0; y < rows_.count; ++y) {
      const std::span<double> sum = result_.row(y);
      std::fill(sum.begin(), sum.end(), 0.0);
      for (std::size_t k = 0; k < weights.size(); ++k) {
        const std::span<const double> row = source(plane, y + int(k));
        for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += weights[k] * row[x];
      }
    }
  }

  // van Herk's method, as slidingReduction does it; a block begins where the rows begin.
  template <class Combine>
  void combine(const Plane& plane, const Combine& combined) {
    const int window = 2 * radius_ + 1, needed = rows_.count + 2 * radius_;
    const auto join = [&](std::span<double> to, std::span<const double> a,
                          std::span<const double> b) {
      for (std::size_t x = 0; x < to.size(); ++x) to[x] = combined(a[x], b[x]);
    };
    const auto copy = [](std::span<double> to, std::span<const double> from) {
      std::copy(from.begin(), from.end(), to.begin());
    };
    for (int i = 0; i < needed; ++i) {
      if (i % window == 0)
        copy(fromLeft_.row(i), source(plane, i));
      else
        join(fromLeft_.row(i), fromLeft_.row(i - 1), source(plane, i));
    }
    // The last block may reach beyond the rows that are needed.
    const int whole = (needed + window - 1) / window * window;
    for (int i = whole - 1; i >= 0; --i) {
      if ((i + 1) % window == 0)
        copy(right_, source(plane, i));
      else
        join(right_, source(plane, i), right_);
      if (i < needed) copy(fromRight_.row(i), right_);
    }
    for (int i = 0; i < rows_.count; ++i) {
      if (i % window == 0)
        copy(result_.row(i), fromRight_.row(i));
      else
        join(result_.row(i), fromRight_.row(i), fromLeft_.row(i + window - 1));
    }
  }

  const Rows known_, rows_;
  const int radius_;
  Plane result_, fromLeft_, fromRight_;
  std::vector<double> right_;
};

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

namespace {

Image<double> encodedRows(const DepthMap& map, const Technique& technique, StorageFormat format,
                          const Rows& rows) {
  const std::vector<Channel> layout = technique.channels();
  Image<double> channels(map.width(), rows.count, int(layout.size()));
  for (int y = 0; y < rows.count; ++y)
    for (int x = 0; x < map.width(); ++x)
      encodeTexel(map.pixel(x, rows.first + y), technique, layout, channels.pixel(x, y));
  storeMap(channels, layout, format);
  return channels;
}

}  // namespace

Image<double> encodeMap(const DepthMap& map, const Technique& technique, StorageFormat format) {
  return encodedRows(map, technique, format, {0, map.height()});
}

Rows reachedRows(const Kernel& kernel, const Rows& rows, int height) {
  const int r = kernel.effectiveRadius();
  const int first = std::max(0, rows.first - r);
  return {first, std::min(height, rows.first + rows.count + r) - first};
}

Image<double> reducedRows(const Image<double>& channels, std::span<const Channel> layout,
                          const Kernel& kernel, const Rows& known, const Rows& rows) {
  const int width = channels.width(), radius = kernel.effectiveRadius();
  const std::vector<double> weights = kernel.weights();
  Image<double> reduced(width, rows.count, int(layout.size()));
  std::vector<double> line(std::size_t(width), 0.0);
  Plane plane(width, known.count);
  ColumnReduction columns(width, known, rows, radius);
  for (std::size_t c = 0; c < layout.size(); ++c) {
    for (int y = 0; y < known.count; ++y) {
      for (int x = 0; x < width; ++x) line[std::size_t(x)] = channels(x, y, int(c));
      if (radius > 0) reduceRow(line, layout[c].reduction, kernel, weights);
      std::copy(line.begin(), line.end(), plane.row(y).begin());
    }
    const Plane& result = columns.run(plane, layout[c].reduction, kernel, weights);
    for (int y = 0; y < rows.count; ++y) {
      const std::span<const double> row = result.row(y);
      for (int x = 0; x < width; ++x) reduced(x, y, int(c)) = row[std::size_t(x)];
    }
  }
  return reduced;
}

Image<double> reduceMap(const Image<double>& channels, std::span<const Channel> layout,
                        const Kernel& kernel) {
  if (kernel.effectiveRadius() == 0) return channels;
  const Rows all{0, channels.height()};
  return reducedRows(channels, layout, kernel, all, all);
}

void storeMap(Image<double>& channels, std::span<const Channel> layout, StorageFormat format) {
  if (format == StorageFormat::Double) return;
  for (int y = 0; y < channels.height(); ++y)
    for (int x = 0; x < channels.width(); ++x)
      for (std::size_t c = 0; c < layout.size(); ++c)
        channels(x, y, int(c)) = storedIn(layout[c], channels(x, y, int(c)), format);
}

Image<double> prefilteredRows(const DepthMap& map, const Technique& technique, const Kernel& kernel,
                              StorageFormat format, const Rows& rows) {
  const std::vector<Channel> layout = technique.channels();
  const Rows known = reachedRows(kernel, rows, map.height());
  const Image<double> encoded = encodedRows(map, technique, format, known);
  Image<double> reduced =
      kernel.effectiveRadius() == 0 ? encoded : reducedRows(encoded, layout, kernel, known, rows);
  storeMap(reduced, layout, format);
  return reduced;
}

Image<double> prefilteredMap(const DepthMap& map, const Technique& technique, const Kernel& kernel,
                             StorageFormat format) {
  return prefilteredRows(map, technique, kernel, format, {0, map.height()});
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
