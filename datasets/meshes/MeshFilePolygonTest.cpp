// Polygons as exporters write them: with holes that a bridge joins to the outline, corners that
// stand twice, corners on straight edges, in any plane, from any starting corner.
#include "datasets/meshes/MeshFilePolygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/scenes/MeshBuilder.h"

namespace umbra::meshfile {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using scenes::Random;
using Ring = std::vector<Vector2d>;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double areaOf(const Ring& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[(i + 1) % ring.size()]);
  return 0.5 * sum;
}

std::size_t below(Random& random, std::size_t limit) {
  return std::min(limit - 1, std::size_t(random.uniform(0.0, double(limit))));
}

// A ring about `centre` whose corners have the given least and largest distance from it.
Ring star(Random& random, const Vector2d& centre, double least, double most, std::size_t corners) {
  Ring ring;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        2.0 * std::numbers::pi * (double(i) + random.uniform(0.0, 0.9)) / double(corners);
    ring.push_back(centre +
                   random.uniform(least, most) * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

bool meetsEdge(const Vector2d& a, const Vector2d& b, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d &p = ring[i], &q = ring[(i + 1) % ring.size()];
    if (p == a || p == b || q == a || q == b) continue;
    const double pa = cross(b - a, p - a), qa = cross(b - a, q - a);
    const double ap = cross(q - p, a - p), bp = cross(q - p, b - p);
    if (pa * qa <= 0.0 && ap * bp <= 0.0) return true;
  }
  return false;
}

// Whether the ring's inside, which is on its left, opens at a corner towards a point (O'Rourke). Of
// the two copies of a corner at a bridge, one opens to either side of it.
bool opensTowards(const Ring& ring, std::size_t corner, const Vector2d& point) {
  const Vector2d &at = ring[corner], &next = ring[(corner + 1) % ring.size()],
                 &before = ring[(corner + ring.size() - 1) % ring.size()];
  const Vector2d out = next - at, in = before - at, to = point - at;
  if (cross(out, in) > 0.0) return cross(out, to) > 0.0 && cross(to, in) > 0.0;
  return !(cross(in, to) >= 0.0 && cross(to, out) >= 0.0);
}

// Joins the hole, which turns the other way, to the ring by the shortest bridge that meets nothing,
// and takes its area off.
void bridge(Ring& ring, double& area, const Ring& hole, const std::vector<Ring>& others) {
  double shortest = 1e300;
  std::size_t from = 0, to = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = 0; j < hole.size(); ++j) {
      const double length = (ring[i] - hole[j]).norm();
      if (length >= shortest || !opensTowards(ring, i, hole[j]) ||
          meetsEdge(ring[i], hole[j], ring) || meetsEdge(ring[i], hole[j], hole))
        continue;
      const auto isFree = [&](const Ring& other) { return !meetsEdge(ring[i], hole[j], other); };
      if (!std::all_of(others.begin(), others.end(), isFree)) continue;
      shortest = length, from = i, to = j;
    }
  if (shortest == 1e300) return;  // no corner sees another one: the polygon goes without this hole
  area -= std::abs(areaOf(hole));
  Ring joined(ring.begin(), ring.begin() + std::ptrdiff_t(from) + 1);
  for (std::size_t j = 0; j <= hole.size(); ++j) joined.push_back(hole[(to + j) % hole.size()]);
  joined.insert(joined.end(), ring.begin() + std::ptrdiff_t(from), ring.end());
  ring = joined;
}

struct Drawn {
  std::vector<Vector3d> corners;
  double area = 0.0;
};

Drawn drawPolygon(Random& random) {
  Ring ring = star(random, {0.0, 0.0}, 1.2, 3.0, 9 + below(random, 20));
  Drawn drawn;
  drawn.area = areaOf(ring);
  std::vector<Ring> holes;
  for (const Vector2d& centre : {Vector2d(-0.4, -0.4), Vector2d(0.4, -0.4), Vector2d(0.0, 0.45)}) {
    if (random.uniform() < 0.4) continue;
    Ring hole = star(random, centre, 0.1, 0.35, 4 + below(random, 8));
    std::reverse(hole.begin(), hole.end());
    holes.push_back(hole);
  }
  while (!holes.empty()) {
    const Ring hole = holes.back();
    holes.pop_back();
    bridge(ring, drawn.area, hole, holes);
  }
  for (std::size_t extra = below(random, 4); extra > 0; --extra) {
    const std::size_t at = below(random, ring.size());
    const Vector2d &here = ring[at], &next = ring[(at + 1) % ring.size()];
    const Vector2d added = random.uniform() < 0.5 ? here : Vector2d(0.5 * (here + next));
    ring.insert(ring.begin() + std::ptrdiff_t(at) + 1, added);
  }
  std::rotate(ring.begin(), ring.begin() + std::ptrdiff_t(below(random, ring.size())), ring.end());
  // Half of them stay in the plane z = 0 with exact coordinates, the others lie anywhere.
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();
  if (random.uniform() < 0.5)
    placement = Eigen::Translation3d(random.uniform(-1e3, 1e3), 5.0, -2.0) *
                Eigen::AngleAxisd(random.uniform(0.0, 6.0), random.direction());
  for (const Vector2d& p : ring) drawn.corners.push_back(placement * Vector3d(p.x(), p.y(), 0.0));
  return drawn;
}

Vector3d areaVector(const std::vector<Vector3d>& corners) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += 0.5 * (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  return sum;
}

Triangulated cutOf(const std::vector<Vector3d>& corners) {
  std::uint64_t testsLeft = manyTests;
  return triangulated(corners, testsLeft);
}

// The sum of the triangles' areas, which no triangle that lies outside or is turned round can make
// right.
double coveredArea(const std::vector<Vector3d>& corners, const Triangulated& cut) {
  const Vector3d normal = areaVector(corners).normalized();
  double sum = 0.0;
  for (const auto& t : cut.triangles) {
    const Vector3d across =
        0.5 * (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]);
    EXPECT_GT(across.dot(normal), -1e-12);
    sum += across.norm();
  }
  return sum;
}

TEST(MeshFilePolygon, HasTheExactAreaOfTenThousandPolygonsWithHoles) {
  Random random(1975);
  std::size_t withHoles = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Drawn drawn = drawPolygon(random);
    const Triangulated cut = cutOf(drawn.corners);
    SCOPED_TRACE("polygon " + std::to_string(i));
    ASSERT_FALSE(cut.crossesItself);
    // Rounding of a thousand units to the sixteenth place, over some hundred products.
    ASSERT_NEAR(coveredArea(drawn.corners, cut), drawn.area, 1e-9);
    withHoles += drawn.corners.size() > 40;
  }
  EXPECT_GT(withHoles, 1000u);
}

TEST(MeshFilePolygon, CutsAHoleWhoseBridgeStartsAnywhere) {
  const std::vector<Vector3d> plate{{0, 2, 0}, {4, 2, 0}, {4, 2, 4}, {0, 2, 4}, {0, 2, 0},
                                    {1, 2, 1}, {1, 2, 3}, {3, 2, 3}, {3, 2, 1}, {1, 2, 1}};
  for (std::size_t start = 0; start < plate.size(); ++start) {
    std::vector<Vector3d> corners = plate;
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(start), corners.end());
    EXPECT_DOUBLE_EQ(coveredArea(corners, cutOf(corners)), 12.0) << start;
    std::reverse(corners.begin(), corners.end());
    EXPECT_DOUBLE_EQ(coveredArea(corners, cutOf(corners)), 12.0) << start;
  }
}

TEST(MeshFilePolygon, SaysThatAPolygonCrossesItself) {
  // An hourglass of different halves: its signed area is not 0, its edges cross.
  const std::vector<Vector3d> hourglass{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {3, 3, 0}};
  EXPECT_TRUE(cutOf(hourglass).crossesItself);
  // A star of five points turns left at each corner, twice round.
  std::vector<Vector3d> star;
  for (int i = 0; i < 5; ++i)
    star.emplace_back(std::cos(i * 2.513274), std::sin(i * 2.513274), 0.0);
  EXPECT_TRUE(cutOf(star).crossesItself);
}

TEST(MeshFilePolygon, TakesAPolygonOfManyCorners) {
  std::vector<Vector3d> comb;  // of 1000 teeth
  for (int i = 0; i < 2000; ++i) comb.emplace_back(i, i % 2 ? 5.0 : 0.0, 0.0);
  comb.emplace_back(1999, -1, 0), comb.emplace_back(0, -1, 0);
  std::reverse(comb.begin(), comb.end());
  const Triangulated cut = cutOf(comb);
  EXPECT_FALSE(cut.crossesItself);
  EXPECT_NEAR(coveredArea(comb, cut), 1999 * 3.5, 1e-6);
  std::uint64_t few = 10'000;
  const Triangulated hurried = triangulated(comb, few);
  EXPECT_TRUE(hurried.hasTooManyCorners);
  EXPECT_FALSE(hurried.crossesItself);
}

}  // namespace
}  // namespace umbra::meshfile
