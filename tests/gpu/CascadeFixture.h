// A frame of several cascades, and the reads of its pixels.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/gpu/FrameFixture.h"
#include "tests/gpu/Rounding.h"

namespace umbra::test {

inline Eigen::Vector3d forwardOf(const Camera& camera) {
  return (camera.target - camera.position).normalized();
}

class Cascaded : public FrameFixture {
 protected:
  Cascaded() {
    settings.map.size = 256;
    settings.map.cascades.count = 3;
  }

  // One of a pixel's reads: its map, its place, and its share of the pixel.
  struct Read {
    int cascade;
    double u, v, weight;
    double shift;  // how far the GPU's rounding moves u and v
  };
  std::vector<Read> readsOf(const SurfacePoint& point) {
    const Cascade& own = renderer->cascades()[std::size_t(point.cascade)];
    // The GPU multiplies them by the size of the map.
    const double shift = 4 * eps;
    std::vector<Read> reads{{point.cascade, point.u, point.v, 1 - point.nextCascade, shift}};
    if (point.nextCascade > 0.0) {
      // The way leads through the whole map, where windows and position are eight roundings of at
      // most 1 each.
      const Cascade& next = renderer->cascades()[std::size_t(point.cascade) + 1];
      reads.push_back({point.cascade + 1, next.u(own.left + own.side * point.u),
                       next.v(own.top + own.side * point.v), point.nextCascade,
                       8 * eps / next.side + shift});
    }
    return reads;
  }

  // The mean of `evaluate(map, u, v)` over a pixel's reads, and how far rounding may move it.
  template <class Evaluate>
  std::pair<double, double> over(const SurfacePoint& point, const Evaluate& evaluate) {
    double value = 0.0, error = 0.0;
    for (const Read& read : readsOf(point)) {
      const DepthMap& map = renderer->depthMap(read.cascade);
      const double exact = evaluate(map, read.u, read.v);
      double worst = 0.0;
      for (double du : {-read.shift, read.shift})
        for (double dv : {-read.shift, read.shift})
          worst = std::max(worst, std::abs(evaluate(map, read.u + du, read.v + dv) - exact));
      value += read.weight * exact;
      error += 2 * worst;
    }
    return {value, error};
  }

  Region regionAt(const DepthMap& map, double u, double v) {
    return regionOf(map, settings.kernel, {settings.read.filter, u, v, {}});
  }
  double visibilityIn(const DepthMap& map, double u, double v, double receiver) {
    const std::vector<double> channels =
        readBilinear(map, *technique, settings.kernel, settings.map.format, u, v);
    return technique->visibility({channels, regionAt(map, u, v)}, receiver);
  }
};

}  // namespace umbra::test
