#include "analysis/frame/ManyReads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "analysis/frame/EveryCore.h"
#include "filters/core/maps/Crop.h"
#include "filters/core/prefilter/Prefilter.h"

namespace umbra {
namespace {

constexpr int tileSide = 64;  // texels; reads that begin in one tile share its prefiltered texels

// The texels that a read mixes along one axis, and the weight of the second.
struct AxisRead {
  int first = 0, second = 0;
  double weight = 0.0;
};

AxisRead axisRead(double position, int size, ReadFilter filter) {
  const auto inside = [size](double texel) { return int(std::clamp(texel, 0.0, size - 1.0)); };
  if (filter == ReadFilter::Point) {
    const int texel = inside(std::floor(position * size));
    return {texel, texel, 0.0};
  }
  // Texel centres sit at half-integers.
  const double corner = position * size - 0.5, whole = std::floor(corner);
  // A box may lie half beyond the map's border; there a texture unit reads the edge texel's box.
  if (filter == ReadFilter::SummedArea) return {int(whole), int(whole) + 1, corner - whole};
  return {inside(whole), inside(whole + 1.0), corner - whole};
}

// A square of prefiltered texels. Reading a box of fixed size at any position equals a bilinear
// read of the same box about the texels; a table of sums does not round the channels of these.
class Tile {
 public:
  Tile(const ReadSubject& subject, int left, int top)
      : subject_(subject), left_(left), top_(top), layout_(subject.technique.channels()) {
    if (!subject.technique.info().prefilterable)
      return;  // such a technique needs each read's own texels
    const int side = tileSide + 2 * margin();
    const DepthMap crop = croppedMap(subject.map, left - margin(), top - margin(), side, side);
    if (subject.filter == ReadFilter::SummedArea)
      channels_ =
          reduceMap(encodeMap(crop, subject.technique, subject.format), layout_, subject.kernel);
    else
      channels_ = prefilteredMap(crop, subject.technique, subject.kernel, subject.format);
    const Channel extremes[] = {{"min", Reduction::Min}, {"max", Reduction::Max}};
    Image<double> depths(side, side, 2);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const auto [low, high] = std::ranges::minmax(crop.pixel(x, y));
        depths(x, y, 0) = low;
        depths(x, y, 1) = high;
      }
    extremes_ = reduceMap(depths, extremes, subject.kernel);
    mixed_.resize(layout_.size());
  }

  ReadVisibility evaluate(const MapRead& read) {
    if (!subject_.technique.info().prefilterable) return evaluateTexels(read);
    const DepthMap& map = subject_.map;
    const AxisRead x = axisRead(read.u, map.width(), subject_.filter);
    const AxisRead y = axisRead(read.v, map.height(), subject_.filter);
    std::ranges::fill(mixed_, 0.0);
    double nearest = 1.0, farthest = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
      const bool right = corner & 1, down = corner & 2;
      const double weight =
          (right ? x.weight : 1.0 - x.weight) * (down ? y.weight : 1.0 - y.weight);
      if (weight == 0.0) continue;
      const int column = (right ? x.second : x.first) - left_ + margin();
      const int row = (down ? y.second : y.first) - top_ + margin();
      const auto texel = channels_.pixel(column, row);
      for (std::size_t c = 0; c < mixed_.size(); ++c) mixed_[c] += weight * texel[c];
      nearest = std::min(nearest, extremes_(column, row, 0));
      farthest = std::max(farthest, extremes_(column, row, 1));
    }
    Region place;  // a region without texels: the technique reads none
    place.kernel = subject_.kernel;
    return {subject_.technique.visibility({mixed_, place}, read.receiver),
            referenceOf(read, nearest, farthest)};
  }

 private:
  // The kernel's reach beyond the tile's own texels, and one texel more for bilinear reads.
  int margin() const { return subject_.kernel.effectiveRadius() + 1; }

  Region regionFor(const MapRead& read) const {
    const double box = 2.0 * subject_.kernel.effectiveRadius() + 1.0;  // only summed areas use it
    return regionOf(subject_.map, subject_.kernel,
                    {subject_.filter, read.u, read.v, {box, box, 1}});
  }

  double referenceOf(const MapRead& read, double nearest, double farthest) const {
    if (subject_.truth) return subject_.truth(regionFor(read), read.receiver);
    if (nearest >= read.receiver) return 1.0;
    if (farthest < read.receiver) return 0.0;
    return referenceVisibility(regionFor(read), read.receiver);
  }

  // A technique that is not prefilterable reads the region's texels and no channels.
  ReadVisibility evaluateTexels(const MapRead& read) const {
    const Region region = regionFor(read);
    return {subject_.technique.visibility({{}, region}, read.receiver),
            subject_.truth ? subject_.truth(region, read.receiver)
                           : referenceVisibility(region, read.receiver)};
  }

  const ReadSubject& subject_;
  int left_, top_;  // the first texel without the margin
  std::vector<Channel> layout_;
  Image<double> channels_, extremes_;
  std::vector<double> mixed_;
};

// The reads of each tile, as indices: those of tile t from begins[t] up to begins[t + 1].
struct Tiles {
  int across = 0, down = 0;
  std::vector<std::uint32_t> begins, numbers;
};

Tiles tilesOf(const ReadSubject& subject, std::span<const MapRead> reads) {
  const int width = subject.map.width(), height = subject.map.height();
  Tiles tiles{(width + tileSide - 1) / tileSide, (height + tileSide - 1) / tileSide, {}, {}};
  std::vector<std::uint32_t> tile(reads.size());
  tiles.begins.assign(std::size_t(tiles.across) * tiles.down + 1, 0);
  for (std::size_t i = 0; i < reads.size(); ++i) {
    const int x = std::max(axisRead(reads[i].u, width, subject.filter).first, 0) / tileSide;
    const int y = std::max(axisRead(reads[i].v, height, subject.filter).first, 0) / tileSide;
    tile[i] = std::uint32_t(y * tiles.across + x);
    ++tiles.begins[tile[i] + 1];
  }
  for (std::size_t t = 1; t < tiles.begins.size(); ++t) tiles.begins[t] += tiles.begins[t - 1];
  std::vector<std::uint32_t> next(tiles.begins.begin(), tiles.begins.end() - 1);
  tiles.numbers.resize(reads.size());
  for (std::size_t i = 0; i < reads.size(); ++i) tiles.numbers[next[tile[i]]++] = std::uint32_t(i);
  return tiles;
}

}  // namespace

std::vector<ReadVisibility> evaluateReads(const ReadSubject& subject,
                                          std::span<const MapRead> reads,
                                          const std::function<void(double)>& progress) {
  const Tiles tiles = tilesOf(subject, reads);
  std::vector<ReadVisibility> results(reads.size());
  const int count = tiles.across * tiles.down;
  onEveryCore(
      count,
      [&](int t) {
        if (tiles.begins[t] == tiles.begins[t + 1]) return;
        Tile tile(subject, t % tiles.across * tileSide, t / tiles.across * tileSide);
        for (std::uint32_t i = tiles.begins[t]; i < tiles.begins[t + 1]; ++i)
          results[tiles.numbers[i]] = tile.evaluate(reads[tiles.numbers[i]]);
      },
      [&](int begun) { progress(double(begun) / count); });
  return results;
}

}  // namespace umbra
