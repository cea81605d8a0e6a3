#include "datasets/scenes/Tree.h"

#include <cmath>
#include <numbers>

namespace umbra::scenes {
namespace {

struct Cluster {
  Vector3d centre;
  double radius = 0.0;
};

// Adds a limb that rises as it leaves the trunk; returns where it ends.
Vector3d addLimb(Mesh& wood, Random& random, const Vector3d& from, const Vector3d& to,
                 double radius) {
  std::vector<Vector3d> path;
  std::vector<double> radii;
  const int pieces = 5;
  for (int i = 0; i <= pieces; ++i) {
    const double t = double(i) / pieces;
    Vector3d point = from + t * (to - from);
    point.y() -= 0.12 * (to - from).norm() * std::sin(std::numbers::pi * t);
    if (i > 0 && i < pieces) point += 0.03 * (to - from).norm() * random.direction();
    path.push_back(point);
    radii.push_back(radius * (1.0 - 0.7 * t));
  }
  append(wood, tube(path, radii, 10));
  return to;
}

}  // namespace

Tree growTree(const TreeShape& shape) {
  Random random(shape.seed);
  Tree tree;
  const double crownBase = 0.42 * shape.height, top = shape.height;
  const double middle = 0.5 * (crownBase + top), halfHeight = 0.5 * (top - crownBase);
  const Vector3d fork(0.03, 0.36 * shape.height, -0.02);
  const Vector3d path[] = {{0, 0, 0}, {0.01, 0.15, 0},       {0.04, 0.18 * shape.height, 0.02},
                           fork,      {-0.03, middle, 0.03}, {0.02, top - 0.3, 0.0}};
  const double radii[] = {1.5 * shape.trunk,  1.1 * shape.trunk, shape.trunk,
                          0.85 * shape.trunk, 0.5 * shape.trunk, 0.1 * shape.trunk};
  tree.wood = tube(path, radii, 20);

  std::vector<Cluster> clusters;
  const int limbs = 15;
  for (int i = 0; i < limbs; ++i) {
    // Limbs stand around the trunk at multiples of the golden angle, from the crown's base to its
    // top.
    const double t = (i + 0.5) / limbs, angle = 2.39996323 * i;
    const double y = middle + halfHeight * (1.7 * t - 0.85);
    const double reach = 0.72 * shape.crown * std::sqrt(1.0 - std::pow(1.7 * t - 0.85, 2));
    const Vector3d end(reach * std::cos(angle), y, reach * std::sin(angle));
    const Vector3d from = fork + (0.55 * t) * Vector3d(0.0, halfHeight * 1.4, 0.0);
    addLimb(tree.wood, random, from, end, 0.42 * shape.trunk * (1.0 - 0.5 * t));
    clusters.push_back({end, shape.crown * random.uniform(0.30, 0.42)});
  }
  for (int i = 0; i < shape.leaves; ++i) {
    const Cluster& cluster = clusters[std::size_t(i) % clusters.size()];
    const Vector3d outward = random.direction();
    // Leaves sit towards the outside of their cluster, where the light is.
    const double r = cluster.radius * std::cbrt(random.uniform(0.15, 1.0));
    const Vector3d stem =
        cluster.centre + r * Vector3d(outward.x(), 0.8 * outward.y(), outward.z());
    const Vector3d along = outward + 0.7 * random.direction() - Vector3d(0.0, 0.35, 0.0);
    const Vector3d normal = Vector3d::UnitY() + 0.8 * random.direction();
    const double length = shape.leafLength * random.uniform(0.75, 1.2);
    addLeaf(tree.leaves, stem, along, normal, length, 0.55 * length);
  }
  return tree;
}

}  // namespace umbra::scenes
