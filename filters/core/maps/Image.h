// A rectangular array of pixels with interleaved channels, row 0 on top.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace umbra {

// Pixel (x, y) has x to the right and y down, from 0, as in an OpenEXR file. Shadow-map textures on
// the GPU have the same orientation: their row 0 is the top row (filters/core/scene/Light.h says
// why).
template <class T>
class Image {
 public:
  Image() = default;
  Image(int width, int height, int channels = 1, T value = T())
      : width_(width),
        height_(height),
        channels_(channels),
        values_(std::size_t(width) * std::size_t(height) * std::size_t(channels), value) {}

  int width() const { return width_; }
  int height() const { return height_; }
  int channels() const { return channels_; }
  bool empty() const { return values_.empty(); }

  T& operator()(int x, int y, int channel = 0) { return values_[index(x, y) + channel]; }
  const T& operator()(int x, int y, int channel = 0) const {
    return values_[index(x, y) + channel];
  }

  // All channels of one pixel.
  std::span<T> pixel(int x, int y) { return {&values_[index(x, y)], std::size_t(channels_)}; }
  std::span<const T> pixel(int x, int y) const {
    return {&values_[index(x, y)], std::size_t(channels_)};
  }

  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

  bool operator==(const Image&) const = default;

 private:
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width_ && y >= 0 && y < height_);
    return (std::size_t(y) * width_ + x) * channels_;
  }

  int width_ = 0;
  int height_ = 0;
  int channels_ = 1;
  std::vector<T> values_;
};

// Linear depth per texel, in [0,1] between the light's near and far plane; nearer is smaller and
// a texel that saw no geometry holds 1. One channel for each sample of a texel.
using DepthMap = Image<double>;

}  // namespace umbra
