#include "datasets/scenes/MeshBuilder.h"

#include <cmath>
#include <numbers>

#include "datasets/meshes/MeshNormals.h"

namespace umbra::scenes {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Rows of `columns` points each become a surface; a row that is closed is joined to itself.
struct Grid {
  std::vector<Eigen::Vector3f> points;
  std::uint32_t columns = 0;

  void add(const Vector3d& point) { points.push_back(point.cast<float>()); }

  std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    const std::uint32_t rows = std::uint32_t(points.size()) / columns;
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
      for (std::uint32_t i = 0; i < columns; ++i) {
        const std::uint32_t next = (i + 1) % columns;
        const std::uint32_t a = row * columns + i, b = row * columns + next;
        const std::uint32_t c = a + columns, d = b + columns;
        result.push_back({a, b, d});
        result.push_back({a, d, c});
      }
    return result;
  }
};

// Welds poles: the points of a row of size 0 become one, so that normals are smooth there.
Mesh finished(const Grid& grid) {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> index(grid.points.size());
  for (std::size_t row = 0; row < grid.points.size(); row += grid.columns) {
    const bool pole = (grid.points[row] - grid.points[row + grid.columns / 2]).norm() < 1e-7f;
    for (std::size_t i = row; i < row + grid.columns; ++i) {
      if (!pole || i == row) points.push_back(grid.points[i]);
      index[i] = std::uint32_t(points.size() - 1);
    }
  }
  std::vector<Triangle> triangles = grid.triangles();
  for (Triangle& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = index[corner];
  return withNormals(points, triangles);
}

// Two unit vectors that make a right-handed frame with `axis`: first × second = axis.
std::pair<Vector3d, Vector3d> sidewaysOf(const Vector3d& axis) {
  const Vector3d hint = std::abs(axis.y()) > 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  const Vector3d first = hint.cross(axis).normalized();
  return {first, axis.cross(first).normalized()};
}

void addRing(Grid& grid, const Vector3d& centre, const std::pair<Vector3d, Vector3d>& sideways,
             double radius) {
  for (std::uint32_t i = 0; i < grid.columns; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / grid.columns;
    grid.add(centre +
             radius * (std::cos(angle) * sideways.first + std::sin(angle) * sideways.second));
  }
}

bool isLeftTurn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() > 0.0;
}

// Ear clipping; quadratic or worse, but outlines have tens of points.
std::vector<Triangle> triangulated(std::span<const Vector2d> outline) {
  std::vector<std::uint32_t> left(outline.size());
  for (std::uint32_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<Triangle> triangles;
  const auto isEar = [&](const Triangle& t) {
    if (!isLeftTurn(outline[t[0]], outline[t[1]], outline[t[2]])) return false;
    for (std::uint32_t other : left) {
      if (other == t[0] || other == t[1] || other == t[2]) continue;
      const Vector2d& p = outline[other];
      if (isLeftTurn(outline[t[0]], outline[t[1]], p) &&
          isLeftTurn(outline[t[1]], outline[t[2]], p) &&
          isLeftTurn(outline[t[2]], outline[t[0]], p))
        return false;
    }
    return true;
  };
  while (left.size() > 2) {
    std::size_t ear = 0;
    Triangle triangle{};
    for (std::size_t i = 0; i < left.size(); ++i) {
      triangle = {left[i], left[(i + 1) % left.size()], left[(i + 2) % left.size()]};
      ear = (i + 1) % left.size();
      if (isEar(triangle)) break;
    }
    triangles.push_back(triangle);
    left.erase(left.begin() + std::ptrdiff_t(ear));
  }
  return triangles;
}

}  // namespace

Mesh box(const Vector3d& low, const Vector3d& high) {
  const Vector2d outline[] = {
      {low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}};
  return extruded(outline, low.z(), high.z());
}

Mesh board(const Vector3d& centre, const Vector3d& size, double angle, const Vector3d& axis) {
  return transformed(box(-0.5 * size, 0.5 * size), moved(centre) * turned(angle, axis));
}

Mesh sphere(const Vector3d& centre, double radius, int segments) {
  std::vector<Vector2d> profile;
  const int rows = segments / 2;
  for (int row = 0; row <= rows; ++row) {
    const double angle = -std::numbers::pi / 2.0 + std::numbers::pi * row / rows;
    const bool pole = row == 0 || row == rows;
    profile.emplace_back(pole ? 0.0 : radius * std::cos(angle), radius * std::sin(angle));
  }
  return transformed(lathe(profile, segments), moved(centre));
}

Mesh cylinder(const Vector3d& from, const Vector3d& to, double fromRadius, double toRadius,
              int segments) {
  const auto sideways = sidewaysOf((to - from).normalized());
  Grid grid;
  grid.columns = std::uint32_t(segments);
  addRing(grid, from, sideways, 0.0);
  if (fromRadius > 0.0) addRing(grid, from, sideways, fromRadius);
  if (toRadius > 0.0) addRing(grid, to, sideways, toRadius);
  addRing(grid, to, sideways, 0.0);
  return finished(grid);
}

Mesh tube(std::span<const Vector3d> path, std::span<const double> radii, int segments) {
  Grid grid;
  grid.columns = std::uint32_t(segments);
  Vector3d first = sidewaysOf((path[1] - path[0]).normalized()).first;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vector3d before = i > 0 ? path[i] - path[i - 1] : path[1] - path[0];
    const Vector3d after = i + 1 < path.size() ? path[i + 1] - path[i] : before;
    const Vector3d axis = (before.normalized() + after.normalized()).normalized();
    // The frame is carried along the path, so that the tube does not twist.
    first = (first - first.dot(axis) * axis).normalized();
    const std::pair<Vector3d, Vector3d> sideways{first, axis.cross(first)};
    if (i == 0) addRing(grid, path[i], sideways, 0.0);
    addRing(grid, path[i], sideways, radii[i]);
    if (i + 1 == path.size()) addRing(grid, path[i], sideways, 0.0);
  }
  return finished(grid);
}

Mesh lathe(std::span<const Vector2d> profile, int segments) {
  Grid grid;
  grid.columns = std::uint32_t(segments);
  const std::pair<Vector3d, Vector3d> sideways{Vector3d::UnitZ(), Vector3d::UnitX()};
  for (const Vector2d& point : profile) addRing(grid, {0.0, point.y(), 0.0}, sideways, point.x());
  return finished(grid);
}

Mesh torus(const Vector3d& centre, const Vector3d& axis, double radius, double thickness,
           int segments, int sides) {
  std::vector<Eigen::Vector3f> points;
  const auto [first, second] = sidewaysOf(axis.normalized());
  std::vector<Triangle> triangles;
  const auto at = [&](int segment, int side) {
    return std::uint32_t((segment % segments) * sides + side % sides);
  };
  for (int i = 0; i < segments; ++i) {
    const double along = 2.0 * std::numbers::pi * i / segments;
    const Vector3d outward = std::cos(along) * first + std::sin(along) * second;
    for (int j = 0; j < sides; ++j) {
      const double round = 2.0 * std::numbers::pi * j / sides;
      points.push_back((centre + (radius + thickness * std::cos(round)) * outward +
                        thickness * std::sin(round) * axis.normalized())
                           .cast<float>());
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return withNormals(points, triangles, 60.0);
}

Mesh extruded(std::span<const Vector2d> outline, double back, double front) {
  const std::uint32_t n = std::uint32_t(outline.size());
  std::vector<Eigen::Vector3f> points;
  for (double z : {front, back})
    for (const Vector2d& p : outline) points.push_back(Vector3d(p.x(), p.y(), z).cast<float>());
  std::vector<Triangle> triangles = triangulated(outline);
  for (std::size_t i = 0, faces = triangles.size(); i < faces; ++i) {
    const Triangle t = triangles[i];
    triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    triangles.push_back({i, i + n, next + n});
    triangles.push_back({i, next + n, next});
  }
  return withNormals(points, triangles);
}

void addLeaf(Mesh& mesh, const Vector3d& stem, const Vector3d& direction, const Vector3d& normal,
             double length, double width) {
  const Vector3d along = direction.normalized();
  const Vector3d across = along.cross(normal).normalized();
  const Vector3d up = across.cross(along);
  const auto point = [&](double x, double y, double z) -> Eigen::Vector3f {
    return (stem + length * x * along + width * y * across + width * z * up).cast<float>();
  };
  const Eigen::Vector3f points[] = {point(0, 0, 0), point(0.45, 0.5, 0.12), point(1, 0, -0.1),
                                    point(0.45, -0.5, 0.12), point(0.45, 0.0, 0.0)};
  const Triangle triangles[] = {{0, 4, 1}, {4, 2, 1}, {0, 3, 4}, {4, 3, 2}};
  append(mesh, withNormals(points, triangles, 10.0));
}

}  // namespace umbra::scenes
