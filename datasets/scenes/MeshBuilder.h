// The shapes that the catalogue's scenes are made of. Lengths are world units, y is up, triangles
// are counter-clockwise seen from outside, normals are unit and break at edges.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "filters/core/scene/Scene.h"

namespace umbra::scenes {

using Eigen::Vector2d;
using Eigen::Vector3d;

Mesh box(const Vector3d& low, const Vector3d& high);

// A board of `size` (along its own x, y, z) about `centre`, turned by `angle` degrees round `axis`.
Mesh board(const Vector3d& centre, const Vector3d& size, double angle = 0.0,
           const Vector3d& axis = Vector3d::UnitY());

Mesh sphere(const Vector3d& centre, double radius, int segments = 48);

// A cylinder or cut cone with caps; a radius of 0 makes a tip.
Mesh cylinder(const Vector3d& from, const Vector3d& to, double fromRadius, double toRadius,
              int segments = 24);

// A round tube along a polyline with rounded joints; `radii` has one radius for each point.
Mesh tube(std::span<const Vector3d> path, std::span<const double> radii, int segments = 12);

// Turns `profile` (distance from the y axis, height; from the bottom to the top) around the y axis.
Mesh lathe(std::span<const Vector2d> profile, int segments = 48);

// A ring of circular section about `axis`.
Mesh torus(const Vector3d& centre, const Vector3d& axis, double radius, double thickness,
           int segments = 48, int sides = 16);

// A prism from z = back to z = front. `outline` is in x and y, counter-clockwise and simple.
Mesh extruded(std::span<const Vector2d> outline, double back, double front);

// A leaf of one sheet, folded a little along its rib; it grows from `stem` along `direction`.
void addLeaf(Mesh& mesh, const Vector3d& stem, const Vector3d& direction, const Vector3d& normal,
             double length, double width);

void append(Mesh& mesh, const Mesh& other);
Mesh transformed(const Mesh& mesh, const Eigen::Affine3d& transform);  // rigid or uniform scale

Eigen::Affine3d moved(const Vector3d& by);
Eigen::Affine3d turned(double degrees, const Vector3d& axis = Vector3d::UnitY());

// Random numbers that are the same on every machine, unlike those of std's distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform(double low = 0.0, double high = 1.0);
  Vector3d direction();  // uniform over the sphere

 private:
  std::uint64_t state_;
};

}  // namespace umbra::scenes
