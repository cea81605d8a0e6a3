// Reads of prefiltered channels, as the shaded frame does them.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "filters/core/maps/Crop.h"
#include "filters/core/maps/MipLevels.h"
#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

// A rectangle of texels of a level, ends included.
struct Block {
  int left = 0, top = 0, right = 0, bottom = 0;

  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
};

Block blockOf(const std::vector<LevelRead>& reads, int level) {
  const LevelRead& any = reads.front();
  const int shift = level - any.level;
  Block block{any.x[0] >> shift, any.y[0] >> shift, any.x[0] >> shift, any.y[0] >> shift};
  for (const LevelRead& read : reads) {
    const int down = level - read.level;
    block.left = std::min(block.left, read.x[0] >> down);
    block.right = std::max(block.right, read.x[1] >> down);
    block.top = std::min(block.top, read.y[0] >> down);
    block.bottom = std::max(block.bottom, read.y[1] >> down);
  }
  return block;
}

// The prefiltered texels of `block`; those beyond the map's edge repeat it.
Image<double> prefilteredBlock(const DepthMap& map, const Technique& technique,
                               const Kernel& kernel, StorageFormat format, const Block& block) {
  const int r = kernel.effectiveRadius();
  const auto inside = [](int texel, int size) { return std::clamp(texel, 0, size - 1); };
  const int left = inside(block.left, map.width()), right = inside(block.right, map.width());
  const int top = inside(block.top, map.height()), bottom = inside(block.bottom, map.height());
  const DepthMap crop =
      croppedMap(map, left - r, top - r, right - left + 1 + 2 * r, bottom - top + 1 + 2 * r);
  const Image<double> prefiltered = prefilteredMap(crop, technique, kernel, format);
  Image<double> result(block.width(), block.height(), prefiltered.channels());
  for (int y = 0; y < result.height(); ++y)
    for (int x = 0; x < result.width(); ++x)
      std::ranges::copy(prefiltered.pixel(inside(block.left + x, map.width()) - left + r,
                                          inside(block.top + y, map.height()) - top + r),
                        result.pixel(x, y).begin());
  return result;
}

double reducedFour(const Channel& channel, double a, double b, double c, double d) {
  switch (channel.reduction) {
    case Reduction::Min:
      return std::min({a, b, c, d});
    case Reduction::Max:
      return std::max({a, b, c, d});
    case Reduction::Mean:
      break;
  }
  return 0.25 * (a + b + c + d);
}

Image<double> halved(const Image<double>& level, std::span<const Channel> layout,
                     StorageFormat format) {
  Image<double> half(level.width() / 2, level.height() / 2, level.channels());
  for (int y = 0; y < half.height(); ++y)
    for (int x = 0; x < half.width(); ++x)
      for (int c = 0; c < half.channels(); ++c)
        half(x, y, c) = reducedFour(layout[c], level(2 * x, 2 * y, c), level(2 * x + 1, 2 * y, c),
                                    level(2 * x, 2 * y + 1, c), level(2 * x + 1, 2 * y + 1, c));
  storeMap(half, layout, format);
  return half;
}

// Computes of every level only the block that lies under the texels which the reads take of the
// coarsest one.
std::vector<double> readLevels(const DepthMap& map, const Technique& technique,
                               const Kernel& kernel, StorageFormat format, const ReadPoint& read) {
  const std::vector<LevelRead> reads = levelReadsOf(read, map.width(), map.height());
  const std::vector<Channel> layout = technique.channels();
  const int finest = reads.front().level, coarsest = reads.back().level;
  const Block block = blockOf(reads, coarsest);
  const int side = 1 << coarsest;
  const Block base{block.left * side, block.top * side, block.right * side + side - 1,
                   block.bottom * side + side - 1};
  Image<double> level = prefilteredBlock(map, technique, kernel, format, base);
  std::vector<double> mixed(layout.size(), 0.0);
  for (int i = 0; i <= coarsest; ++i) {
    if (i > 0) level = halved(level, layout, format);
    if (i < finest) continue;
    for (const LevelRead& at : reads) {
      if (at.level != i) continue;
      for (int corner = 0; corner < 4; ++corner) {
        const int right = corner & 1, down = corner >> 1;
        const double weight =
            at.weight * (right ? at.fx : 1.0 - at.fx) * (down ? at.fy : 1.0 - at.fy);
        const auto texel =
            level.pixel(at.x[right] - (base.left >> i), at.y[down] - (base.top >> i));
        for (std::size_t c = 0; c < layout.size(); ++c) mixed[c] += weight * texel[c];
      }
    }
  }
  return mixed;
}

// A table of sums holds every digit: only the encoded channels that it adds up are rounded.
std::vector<double> readTable(const DepthMap& map, const Technique& technique, const Kernel& kernel,
                              StorageFormat format, const ReadPoint& read) {
  const std::vector<Channel> layout = technique.channels();
  for (const Channel& channel : layout)
    if (channel.reduction != Reduction::Mean)
      throw Error(ErrorKind::BadCommandLine,
                  "filter sat: a table of sums has no minima and maxima, which " +
                      std::string(technique.info().id) + " needs; take trilinear or anisotropic");
  const Region region = regionOf(map, kernel, read);
  std::vector<long double> sums(layout.size(), 0.0L);
  for (std::size_t i = 0; i < region.texels.size(); i += region.samples) {
    const RegionTexel& texel = region.texels[i];
    DepthMap one(1, 1, map.channels());
    std::ranges::copy(map.pixel(texel.x, texel.y), one.pixel(0, 0).begin());
    const Image<double> encoded = encodeMap(one, technique, format);
    for (std::size_t c = 0; c < layout.size(); ++c)
      sums[c] += static_cast<long double>(texel.weight) * region.samples * encoded(0, 0, int(c));
  }
  return {sums.begin(), sums.end()};
}

}  // namespace

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
  switch (read.filter) {
    case ReadFilter::Bilinear:
      return readBilinear(map, technique, kernel, format, read.u, read.v);
    case ReadFilter::Trilinear:
    case ReadFilter::Anisotropic:
      return readLevels(map, technique, kernel, format, read);
    case ReadFilter::SummedArea:
      return readTable(map, technique, kernel, format, read);
    case ReadFilter::Point:
      break;
  }
  return prefilteredRegion(regionOf(map, kernel, read), technique, format);
}

}  // namespace umbra
