#include "filters/techniques/msm/Hamburger.h"

#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

const double root3 = std::sqrt(3.0);

struct Nodes {
  double near = 0.0, far = 0.0;
};

// The roots of a z² + b z + c, which are real except for rounding. a ≠ 0.
Nodes roots(double a, double b, double c) {
  const double discriminant = std::max(b * b - 4.0 * a * c, 0.0);
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const double first = q / a;
  const double second = q != 0.0 ? c / q : first;
  return {std::min(first, second), std::max(first, second)};
}

// There is one distribution on three depths, one of them `receiver`, that has the moments `b`. This
// finds its other two depths: the roots of the polynomial whose coefficients solve B c = (1, z, z²)
// for the Hankel matrix B of the moments. B = L D Lᵀ. Everything is multiplied by the last pivot,
// which is 0 where two depths explain the moments by themselves; those two are then the roots.
template <class Record>
Nodes nodesBeside(double receiver, const Moments4& b, const Record& record) {
  const double l10 = b[0], l20 = b[1];
  const double d1 =
      record("D₁", "first pivot: the variance", "b₂ − b₁²", std::max(b[1] - b[0] * b[0], 1e-30));
  const double l21 = (b[2] - b[1] * b[0]) / d1;
  const double d2 =
      record("D₂", "last pivot: 0 where two depths explain the moments", "b₄ − b₂² − L₂₁² D₁",
             std::max(b[3] - b[1] * b[1] - l21 * l21 * d1, 0.0));
  const double y1 = receiver - l10;
  const double y2 = receiver * receiver - l20 - l21 * y1;
  // y2 = 0 puts one depth infinitely far away; 1e-30 is far enough.
  const double c2 = std::abs(y2) < 1e-30 ? 1e-30 : y2;
  const double c1 = d2 * y1 / d1 - l21 * c2;
  const double c0 = d2 - l10 * c1 - l20 * c2;
  return roots(c2, c1, c0);
}

template <class Record>
double boundOf(const Moments4& moments, double receiver, double bias, const Record& record) {
  record("α", "moment bias", "", bias);
  Moments4 b = moments;
  for (int k = 0; k < 4; ++k) {
    b[k] += bias * (0.5 - b[k]);
    record.numbered(k + 1)("b", "moment, moved towards ½", "M + α(½ − M)", b[k]);
  }
  const auto [near, far] = nodesBeside(receiver, b, record);
  record("z₁", "the nearer of the other two depths of the worst distribution",
         "root of c₀ + c₁z + c₂z²", near);
  record("z₂", "the farther of them", "the other root", far);
  if (receiver <= near)
    return record("p_max", "the receiver is before both: all may be lit", "1 for z_r ≤ z₁", 1.0);
  // In that distribution, the weight of the depths before the receiver is certainly occluded.
  const bool between = receiver <= far;
  const double occluded = between ? (receiver * far - b[0] * (receiver + far) + b[1]) /
                                        ((far - near) * (receiver - near))
                                  : 1.0 - (near * far - b[0] * (near + far) + b[1]) /
                                              ((receiver - near) * (receiver - far));
  record("G", "weight that surely lies before the receiver", between ? "of z₁" : "of z₁ and z₂",
         occluded);
  return record("p_max", "the most that the moments allow to be lit", "1 − G",
                std::clamp(1.0 - occluded, 0.0, 1.0));
}

}  // namespace

Moments4 toQuantised(double z) {
  const double x = 2.0 * z - 1.0, x2 = x * x;
  return {x * (1.5 - 2.0 * x2) + 0.5, 4.0 * x2 * (1.0 - x2),
          x * root3 * (0.5 - x2 * 2.0 / 9.0) + 0.5, 0.5 * x2 * (1.0 + x2)};
}

Moments4 fromQuantised(const Moments4& channels) {
  const double odd0 = channels[0] - 0.5, odd2 = root3 * (channels[2] - 0.5);
  // First the moments of x,
  const double x1 = odd2 - odd0 / 3.0;
  const double x3 = 0.75 * (odd2 - odd0);
  const double x2 = channels[3] + 0.125 * channels[1];
  const double x4 = channels[3] - 0.125 * channels[1];
  // then those of z = (x + 1)/2, by the binomial theorem.
  return {0.5 * (1.0 + x1), 0.25 * (1.0 + 2.0 * x1 + x2), 0.125 * (1.0 + 3.0 * x1 + 3.0 * x2 + x3),
          0.0625 * (1.0 + 4.0 * x1 + 6.0 * x2 + 4.0 * x3 + x4)};
}

double hamburgerVisibility(const Moments4& moments, double receiver, double bias) {
  return boundOf(moments, receiver, bias, Unrecorded());
}

double hamburgerVisibility(const Moments4& moments, double receiver, double bias,
                           const TraceRecorder& record) {
  return boundOf(moments, receiver, bias, record);
}

}  // namespace umbra
