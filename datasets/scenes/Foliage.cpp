// Shrubs, ferns and two trees over a path: leaves over leaves over leaves.
#include <cmath>
#include <numbers>

#include "datasets/scenes/Scenes.h"
#include "datasets/scenes/Tree.h"

namespace umbra::scenes {
namespace {

Mesh shrub(const Vector3d& foot, double radius, int leaves, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  const Vector3d centre = foot + Vector3d(0.0, 0.85 * radius, 0.0);
  for (int i = 0; i < leaves; ++i) {
    Vector3d outward = random.direction();
    if (outward.y() < -0.5) outward.y() = -outward.y();
    const Vector3d stem = centre + radius * std::cbrt(random.uniform(0.2, 1.0)) * outward;
    const double length = 0.16 * random.uniform(0.7, 1.2);
    addLeaf(mesh, stem, outward + 0.6 * random.direction(),
            Vector3d::UnitY() + 0.7 * random.direction(), length, 0.5 * length);
  }
  return mesh;
}

// Fronds that rise from one foot and droop, with leaflets on both sides.
Mesh fern(const Vector3d& foot, double size, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  const int fronds = 13, pairs = 16;
  for (int i = 0; i < fronds; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(-0.3, 0.3)) / fronds;
    const Vector3d out(std::cos(angle), 0.0, std::sin(angle));
    const Vector3d side = Vector3d::UnitY().cross(out);
    const double reach = size * random.uniform(0.8, 1.15);
    for (int k = 1; k <= pairs; ++k) {
      const double t = double(k) / pairs;
      const Vector3d rib = foot + reach * (t * out + (1.15 * t - 1.05 * t * t) * Vector3d::UnitY());
      const double length = reach * (0.34 * std::sin(std::numbers::pi * (0.12 + 0.85 * t)) + 0.03);
      for (double hand : {-1.0, 1.0})
        addLeaf(mesh, rib, hand * side + 0.45 * out - 0.1 * Vector3d::UnitY(), Vector3d::UnitY(),
                length, 0.30 * length);
    }
  }
  return mesh;
}

Scene foliageScene(const Values& values) {
  using namespace colours;
  Scene scene;
  const int leaves = int(values.at("leaves"));
  const Tree tall =
      growTree({.height = 4.4, .crown = 1.55, .trunk = 0.11, .leaves = leaves, .seed = 3});
  const Tree small = growTree({.height = 3.2,
                               .crown = 1.15,
                               .trunk = 0.08,
                               .leaves = leaves * 2 / 3,
                               .leafLength = 0.19,
                               .seed = 5});
  const Eigen::Affine3d left = moved({-1.45, 0.0, -0.9}), right = moved({0.85, 0.0, -1.1});
  Mesh shrubs, ferns, stones;
  append(shrubs, shrub({-1.75, 0.0, 0.35}, 0.50, 1200, 11));
  append(shrubs, shrub({0.30, 0.0, -1.0}, 0.60, 1500, 12));
  append(shrubs, shrub({1.95, 0.0, 0.45}, 0.42, 900, 13));
  append(ferns, fern({-0.75, 0.0, 0.25}, 0.75, 21));
  append(ferns, fern({0.95, 0.0, 0.35}, 0.65, 22));
  append(ferns, fern({-1.15, 0.0, 1.25}, 0.55, 23));
  append(ferns, fern({0.15, 0.0, 1.15}, 0.50, 24));
  for (const Vector3d& at : {Vector3d(0.1, 0.05, 0.35), Vector3d(-0.45, 0.04, 1.05),
                             Vector3d(0.75, 0.06, 1.30), Vector3d(1.55, 0.08, 1.15)})
    append(stones,
           transformed(sphere(Vector3d::Zero(), 0.22, 40), moved(at) * turned(70.0 * at.x())));
  scene.objects = {object("tall trunk", transformed(tall.wood, left), bark),
                   object("small trunk", transformed(small.wood, right), bark),
                   object("tall crown", transformed(tall.leaves, left), leaf),
                   object("small crown", transformed(small.leaves, right), darkLeaf),
                   object("shrubs", std::move(shrubs), darkLeaf),
                   object("ferns", std::move(ferns), leaf),
                   object("stones", std::move(stones), stone)};
  addGround(scene, {0.05, 0.0, 0.1}, 2.75, 2.4, sand, lawn);
  scene.light = sun({-4.4, 7.2, 0.2}, {0.0, 0.6, 0.3});
  scene.camera = lookFrom({0.9, 3.4, 7.6}, {0.0, 1.95, -0.3}, 38.0);
  return scene;
}

}  // namespace

SceneEntry foliage() {
  return {{.name = "foliage",
           .title = "Leaves over leaves",
           .description = "A filter region holds a dozen depths here, more than two moments can "
                          "tell apart. Look at the ground under\nthe ferns and shrubs, and at the "
                          "crowns' inner leaves: hardly any deep shadow stays dark.",
           .figure = "Annen 2007, §5",
           .parameters = {{"leaves", "leaves of the tall tree", 500, 12000, 4200}}},
          foliageScene};
}

}  // namespace umbra::scenes
