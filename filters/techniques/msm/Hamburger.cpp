#include "filters/techniques/msm/Hamburger.h"

#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

const double root3 = std::sqrt(3.0);

struct Nodes {
  double near = 0.0, far = 0.0;
};

// The roots of a z² + b z + c, which are real but for rounding. a ≠ 0.
Nodes roots(double a, double b, double c) {
  const double discriminant = std::max(b * b - 4.0 * a * c, 0.0);
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const double first = q / a;
  const double second = q != 0.0 ? c / q : first;
  return {std::min(first, second), std::max(first, second)};
}

// The other two depths of the one distribution on three depths, one of them `receiver`, that has
// moments `b`: the roots of the polynomial whose coefficients solve B c = (1, z, z²) for the Hankel
// matrix B of the moments. B = L D Lᵀ; everything is multiplied by the last pivot, which is 0 where
// two depths explain the moments by themselves, and those two are then the roots.
Nodes nodesBeside(double receiver, const Moments4& b) {
  const double l10 = b[0], l20 = b[1];
  const double d1 = std::max(b[1] - b[0] * b[0], 1e-30);  // the variance
  const double l21 = (b[2] - b[1] * b[0]) / d1;
  const double d2 = std::max(b[3] - b[1] * b[1] - l21 * l21 * d1, 0.0);
  const double y1 = receiver - l10;
  const double y2 = receiver * receiver - l20 - l21 * y1;
  // y2 = 0 puts one depth infinitely far away; 1e-30 is far enough.
  const double c2 = std::abs(y2) < 1e-30 ? 1e-30 : y2;
  const double c1 = d2 * y1 / d1 - l21 * c2;
  const double c0 = d2 - l10 * c1 - l20 * c2;
  return roots(c2, c1, c0);
}

}  // namespace

Moments4 toQuantised(double z) {
  const double x = 2.0 * z - 1.0, x2 = x * x;
  return {x * (1.5 - 2.0 * x2) + 0.5, 4.0 * x2 * (1.0 - x2),
          x * root3 * (0.5 - x2 * 2.0 / 9.0) + 0.5, 0.5 * x2 * (1.0 + x2)};
}

Moments4 fromQuantised(const Moments4& channels) {
  const double odd0 = channels[0] - 0.5, odd2 = root3 * (channels[2] - 0.5);
  // The moments of x …
  const double x1 = odd2 - odd0 / 3.0;
  const double x3 = 0.75 * (odd2 - odd0);
  const double x2 = channels[3] + 0.125 * channels[1];
  const double x4 = channels[3] - 0.125 * channels[1];
  // … and those of z = (x + 1)/2, by the binomial theorem.
  return {0.5 * (1.0 + x1), 0.25 * (1.0 + 2.0 * x1 + x2), 0.125 * (1.0 + 3.0 * x1 + 3.0 * x2 + x3),
          0.0625 * (1.0 + 4.0 * x1 + 6.0 * x2 + 4.0 * x3 + x4)};
}

double hamburgerVisibility(const Moments4& moments, double receiver, double bias) {
  Moments4 b = moments;
  for (double& moment : b) moment += bias * (0.5 - moment);
  const auto [near, far] = nodesBeside(receiver, b);
  if (receiver <= near) return 1.0;
  // The weight of the depths before the receiver in that distribution is what is surely occluded.
  const bool between = receiver <= far;
  const double occluded = between ? (receiver * far - b[0] * (receiver + far) + b[1]) /
                                        ((far - near) * (receiver - near))
                                  : 1.0 - (near * far - b[0] * (near + far) + b[1]) /
                                              ((receiver - near) * (receiver - far));
  return std::clamp(1.0 - occluded, 0.0, 1.0);
}

}  // namespace umbra
