// The same depth in three measures: the file's value, the world's distance, and the linear depth
// in [0, 1] that techniques see.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "datasets/maps/DepthProjection.h"

namespace umbra {

class DepthScale {
 public:
  DepthScale() = default;
  // `atZero` and `atOne` are the file's values of window depth 0 and 1. `farthest` is where linear
  // depth is 1, in world units, for a projection that names no far plane.
  DepthScale(double atZero, double atOne, const DepthProjection& projection, double farthest,
             int width, int height);

  // World distances where linear depth is 0 and 1. Without a projection the file's values are the
  // world's.
  double near() const { return near_; }
  double far() const { return far_; }

  // Whether one value of the file is another depth at another texel.
  bool dependsOnTexel() const { return projection_.euclidAngle > 0.0; }

  // The texel is counted from the map's corner: only a distance to the light depends on it. Depths
  // are not limited to [0, 1].
  double linearOfFile(double value, int x, int y) const;
  double worldOfFile(double value, int x, int y) const;
  double linearOfWorld(double distance) const;
  double fileOf(double linear, int x, int y) const;
  double worldOf(double linear) const;

 private:
  // The distance to the light over the distance to its plane.
  double stretch(int x, int y) const;

  double atZero_ = 0.0, atOne_ = 1.0;
  DepthProjection projection_;
  double near_ = 0.0, far_ = 1.0;
  int width_ = 1, height_ = 1;
};

// A depth as a person gives it: "0.7" is linear, "6w" in world units, "0.97778f" the file's value.
struct GivenDepth {
  enum class Measure { Linear, World, File };
  double value = 0.0;
  Measure measure = Measure::Linear;
};
// Nothing where the text is none of these.
std::optional<GivenDepth> givenDepthFrom(std::string_view text);
double linearOf(const GivenDepth& given, const DepthScale& scale, int x, int y);

}  // namespace umbra
