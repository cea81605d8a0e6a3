#include "datasets/meshes/MeshFilePolygon.h"

#include <Eigen/Geometry>
#include <numeric>

namespace umbra::meshfile {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

// The time to find an ear grows with the cube of the number of corners. A polygon with more corners
// than this is a disc or a damaged file.
constexpr std::size_t manyCorners = 400;

class Polygon {
 public:
  explicit Polygon(std::span<const Vector3d> corners) : corners_(corners) {
    // Newell's method: it adds up the corners' cross products, relative to one of them.
    for (std::size_t i = 0; i < corners.size(); ++i)
      normal_ += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return (corners_[b] - corners_[a]).cross(corners_[c] - corners_[b]).dot(normal_);
  }

  bool isConvex() const {
    const auto n = std::uint32_t(corners_.size());
    for (std::uint32_t i = 0; i < n; ++i)
      if (turn(i, (i + 1) % n, (i + 2) % n) < 0.0) return false;
    return true;
  }

  // Whether the corner at `i` of the remaining polygon can be cut off.
  bool isEar(const std::vector<std::uint32_t>& left, std::size_t i) const {
    const std::size_t n = left.size();
    const std::uint32_t a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
    if (turn(a, b, c) <= 0.0) return false;
    for (std::uint32_t p : left)
      if (p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
          turn(c, a, p) >= 0.0)
        return false;
    return true;
  }

 private:
  std::span<const Vector3d> corners_;
  Vector3d normal_ = Vector3d::Zero();
};

}  // namespace

std::vector<Triangle> triangulated(std::span<const Vector3d> corners) {
  const Polygon polygon(corners);
  std::vector<Triangle> triangles;
  const auto n = std::uint32_t(corners.size());
  if (n > manyCorners || polygon.isConvex()) {
    for (std::uint32_t i = 2; i < n; ++i) triangles.push_back({0, i - 1, i});
    return triangles;
  }
  std::vector<std::uint32_t> left(n);
  std::iota(left.begin(), left.end(), 0u);
  while (left.size() > 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !polygon.isEar(left, ear)) ++ear;
    if (ear == left.size()) ear = 1;  // the polygon crosses itself: any corner is cut off
    const std::size_t before = (ear + left.size() - 1) % left.size();
    triangles.push_back({left[before], left[ear], left[(ear + 1) % left.size()]});
    left.erase(left.begin() + std::ptrdiff_t(ear));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace umbra::meshfile
