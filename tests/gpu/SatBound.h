// How far what a summed-area table gives may be from exact means.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "filters/core/maps/Image.h"
#include "tests/gpu/Rounding.h"

namespace umbra::test {

// For one technique on one map, whose channels before any sum are `encoded`.
class SatBound {
 public:
  SatBound(const Technique& technique, StorageFormat format, const Image<double>& encoded)
      : format_(format),
        layout_(technique.channels()),
        width_(encoded.width()),
        height_(encoded.height()),
        extents_(layout_.size()) {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x)
        for (std::size_t c = 0; c < layout_.size(); ++c) {
          const double value = encoded(x, y, int(c));
          extents_[c].low = std::min(extents_[c].low, value);
          extents_[c].high = std::max(extents_[c].high, value);
          extents_[c].total += std::abs(value);
        }
  }

  // How far each channel's mean over the box may be off.
  std::vector<double> operator()(SatPrecision precision, const ReadPoint& read) const {
    std::vector<double> off(layout_.size());
    for (std::size_t c = 0; c < off.size(); ++c) off[c] = ofSums(c, precision, read);
    return off;
  }

  // Whether sums over the map stay within the range of a float; those of steep exponentials do not,
  // and nothing is promised of them (whyInexact).
  bool holds() const {
    return std::all_of(extents_.begin(), extents_.end(), [&](const Extent& extent) {
      const double largest = std::max(std::abs(extent.low), std::abs(extent.high));
      return largest * width_ * height_ < largestOf(StorageFormat::Float);
    });
  }

 private:
  struct Extent {
    double low = 1e300, high = -1e300, total = 0.0;
  };

  // How far one channel's box mean may be off: sums of floats gather what the nodes round (thrice
  // for each of 3 + 3 passes), four of them and three differences along both axes for each of nine
  // rectangles.
  double ofSums(std::size_t channel, SatPrecision precision, const ReadPoint& read) const {
    const Footprint& box = read.footprint;
    const auto [low, high, sum] = extents_[channel];
    const Channel& declared = layout_[channel];
    const bool fractions = isNormalised(format_);
    const double range = declared.high - declared.low, texels = double(width_) * height_;
    // Nine weighted terms of the largest size, and the box's ends, which move the mean.
    const double size = std::max({std::abs(low), std::abs(high), fractions ? range : 0.0});
    const double moved = (width_ + 2 * box.x) / box.x + (height_ + 2 * box.y) / box.y;
    const double reading = eps * (44 * size + moved * (high - low));
    if (precision == SatPrecision::Integer)
      return reading + (format_ == StorageFormat::Unorm16 ? 0.0 : range * 0.5 / 65535);
    const double total = precision == SatPrecision::Centred ? texels * (high - low)
                         : fractions                        ? texels * range
                                                            : sum;
    return reading + (4 * 3 * 6 + 6) * eps * total *
                         largestSatWeight(read.u * width_, box.x, width_) *
                         largestSatWeight(read.v * height_, box.y, height_);
  }

  StorageFormat format_;
  std::vector<Channel> layout_;
  int width_, height_;
  std::vector<Extent> extents_;  // of each channel
};

}  // namespace umbra::test
