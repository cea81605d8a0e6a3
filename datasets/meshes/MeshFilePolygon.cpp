#include "datasets/meshes/MeshFilePolygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace umbra::meshfile {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

// Twice the signed area; positive where a, b, c turn to the left. What is smaller than rounding
// makes of three points on a line is 0.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
  const double difference = left - right;
  return std::abs(difference) > 4e-16 * (std::abs(left) + std::abs(right)) ? difference : 0.0;
}

// The part of a segment that lies inside all half planes added so far, as an open interval of its
// parameter.
class InsidePart {
 public:
  // `from` and `to` are the distances of the segment's ends from a half plane's edge, positive
  // inside.
  void clip(double from, double to) {
    if (from <= 0.0 && to <= 0.0) low_ = high_ = 0.0;
    if (from < 0.0 && to > 0.0) low_ = std::max(low_, from / (from - to));
    if (from > 0.0 && to < 0.0) high_ = std::min(high_, from / (from - to));
  }
  // An edge that only touches a corner is inside by no more than rounding.
  bool isEmpty() const { return !(high_ - low_ > 1e-12); }

 private:
  double low_ = 0.0, high_ = 1.0;
};

class EarClipping {
 public:
  explicit EarClipping(std::vector<Vector2d> points) : points_(std::move(points)) {
    ring_.resize(points_.size());
    std::iota(ring_.begin(), ring_.end(), 0u);
  }

  bool isConvex() const {
    for (std::size_t i = 0; i < ring_.size(); ++i)
      if (turnAt(i) <= 0.0) return false;
    return turnsOnce();
  }

  Triangulated run(std::uint64_t& testsLeft) {
    Triangulated result;
    double covered = 0.0, signedSum = 0.0;
    std::size_t at = 1, tried = 0;
    while (ring_.size() >= 3) {
      at %= ring_.size();
      if (testsLeft < ring_.size()) return cutAsConvex(std::move(result));
      const bool isStuck = tried >= ring_.size();
      if (isStuck) at = flattest();
      const double area = turnAt(at);
      if (area == 0.0 || isStuck || (area > 0.0 && isEar(at, testsLeft))) {
        if (area != 0.0) result.triangles.push_back({before(at), ring_[at], after(at)});
        covered += std::abs(area);
        signedSum += area;
        ring_.erase(ring_.begin() + std::ptrdiff_t(at));
        tried = 0;
      } else {
        ++at;
        ++tried;
      }
    }
    // Corners that are meant to lie on a line lie beside it by what their numbers were rounded to;
    // a file of floats has seven digits.
    result.crossesItself = covered - signedSum > 1e-6 * covered;
    return result;
  }

 private:
  std::uint32_t before(std::size_t i) const { return ring_[i == 0 ? ring_.size() - 1 : i - 1]; }
  std::uint32_t after(std::size_t i) const { return ring_[i + 1 == ring_.size() ? 0 : i + 1]; }
  double turnAt(std::size_t i) const {
    return turn(points_[before(i)], points_[ring_[i]], points_[after(i)]);
  }

  Triangulated cutAsConvex(Triangulated result) const {
    for (std::size_t i = 2; i < ring_.size(); ++i)
      result.triangles.push_back({ring_[0], ring_[i - 1], ring_[i]});
    result.hasTooManyCorners = true;
    return result;
  }

  std::size_t flattest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < ring_.size(); ++i)
      if (std::abs(turnAt(i)) < std::abs(turnAt(best))) best = i;
    return best;
  }

  // Whether a polygon that turns left at each corner goes round once, unlike a star.
  bool turnsOnce() const {
    int changes = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const double in = points_[ring_[i]].x() - points_[before(i)].x();
      const double out = points_[after(i)].x() - points_[ring_[i]].x();
      changes += (in > 0.0) != (out > 0.0);
    }
    return changes <= 2;
  }

  bool isEar(std::size_t at, std::uint64_t& testsLeft) const {
    testsLeft -= ring_.size();
    const Vector2d &a = points_[before(at)], &b = points_[ring_[at]], &c = points_[after(at)];
    const Vector2d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vector2d &p = points_[ring_[i]], &q = points_[after(i)];
      if ((p.cwiseMin(q).array() >= high.array()).any() ||
          (p.cwiseMax(q).array() <= low.array()).any())
        continue;
      InsidePart part;
      part.clip(turn(a, b, p), turn(a, b, q));
      part.clip(turn(b, c, p), turn(b, c, q));
      part.clip(turn(c, a, p), turn(c, a, q));
      if (!part.isEmpty()) return false;
    }
    return true;
  }

  std::vector<Vector2d> points_;
  std::vector<std::uint32_t> ring_;  // the corners that are left
};

// Newell's method: it adds up the corners' cross products, relative to one of them.
Vector3d normalOf(std::span<const Vector3d> corners) {
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  return normal;
}

std::vector<Vector2d> seenAlongAxis(std::span<const Vector3d> corners) {
  const Vector3d normal = normalOf(corners);
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  // Seen from the side to which the normal points, so that the polygon turns to the left.
  const int right = (axis + 1) % 3, up = (axis + 2) % 3;
  const bool fromBehind = normal[axis] < 0.0;
  std::vector<Vector2d> points;
  points.reserve(corners.size());
  for (const Vector3d& corner : corners)
    points.emplace_back(corner[fromBehind ? up : right], corner[fromBehind ? right : up]);
  return points;
}

}  // namespace

Triangulated triangulated(std::span<const Vector3d> corners, std::uint64_t& testsLeft) {
  const auto n = std::uint32_t(corners.size());
  if (n == 3) return {{{0, 1, 2}}, false, false};
  EarClipping clipping(seenAlongAxis(corners));
  if (!clipping.isConvex()) return clipping.run(testsLeft);
  Triangulated fan;
  for (std::uint32_t i = 2; i < n; ++i) fan.triangles.push_back({0, i - 1, i});
  return fan;
}

}  // namespace umbra::meshfile
