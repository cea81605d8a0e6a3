// A picket fence in front of other objects.
#include <cmath>

#include "datasets/scenes/Scenes.h"

namespace umbra::scenes {
namespace {

constexpr double railHalf = 2.35, fenceZ = 0.95;

Mesh picket(double x, double width, double height) {
  const double half = 0.5 * width, shoulder = height - 0.8 * width;
  const Vector2d outline[] = {
      {x - half, 0.06}, {x + half, 0.06}, {x + half, shoulder}, {x, height}, {x - half, shoulder}};
  return extruded(outline, fenceZ, fenceZ + 0.035);
}

Mesh fence(int pickets) {
  Mesh mesh;
  const double pitch = 2.0 * railHalf / pickets;
  for (int i = 0; i < pickets; ++i)
    append(mesh, picket(-railHalf + (i + 0.5) * pitch, 0.55 * pitch, 1.5));
  for (double y : {0.40, 1.12})
    append(mesh, box({-railHalf, y - 0.045, fenceZ - 0.05}, {railHalf, y + 0.045, fenceZ}));
  for (double x : {-railHalf, 0.0, railHalf})
    append(mesh, box({x - 0.05, 0.0, fenceZ - 0.15}, {x + 0.05, 1.42, fenceZ - 0.05}));
  return mesh;
}

// A wall of staggered bricks with joints; its front faces +z.
Mesh wall(double low, double high, double top, double z) {
  const double height = 0.17, length = 0.44, joint = 0.014;
  Mesh mesh = box({low + 0.01, 0.0, z - 0.20}, {high - 0.01, top - 0.02, z - 0.015});
  for (int row = 0; row * height < top - 0.01; ++row)
    for (double x = low - (row % 2 == 0 ? 0.0 : 0.5 * length); x < high; x += length) {
      const double left = std::max(x, low), right = std::min(x + length, high) - joint;
      if (right - left < 0.05) continue;
      append(mesh, box({left, row * height, z - 0.21}, {right, (row + 1) * height - joint, z}));
    }
  return mesh;
}

Mesh flowerPot() {
  const Vector2d profile[] = {{0.0, 0.0},   {0.20, 0.0},  {0.28, 0.42}, {0.32, 0.42},
                              {0.33, 0.52}, {0.29, 0.52}, {0.27, 0.44}, {0.0, 0.44}};
  return lathe(profile, 48);
}

Mesh shrub(const Vector3d& centre, double radius) {
  Random random(7);
  Mesh mesh;
  for (int i = 0; i < 700; ++i) {
    const Vector3d outward = random.direction();
    const Vector3d stem = centre + radius * std::cbrt(random.uniform(0.1, 1.0)) * outward;
    addLeaf(mesh, stem, outward + 0.6 * random.direction(),
            Vector3d::UnitY() + 0.6 * random.direction(), 0.17, 0.09);
  }
  return mesh;
}

Scene fenceScene(const Values& values) {
  using namespace colours;
  Scene scene;
  scene.objects = {object("fence", fence(int(values.at("pickets"))), white),
                   object("wall", wall(-2.1, 0.2, 0.72, -0.1), brick),
                   object("ball", sphere({-1.45, 0.32, 0.42}, 0.32, 64), ochre),
                   object("pot", transformed(flowerPot(), moved({1.05, 0.0, 0.2})), rose),
                   object("shrub", shrub({1.05, 0.80, 0.2}, 0.42), leaf),
                   object("crate", board({1.85, 0.22, -0.55}, {0.55, 0.44, 0.55}, 24.0), wood),
                   object("lid", board({1.85, 0.46, -0.55}, {0.63, 0.04, 0.63}, 24.0), wood)};
  addGround(scene, {0.0, 0.0, -0.55}, 2.6, 1.95, sand, lawn);
  scene.light = sun({1.7, 5.6, 6.4}, {0.0, 0.4, 0.0});
  scene.camera = lookFrom({-4.6, 3.6, -6.2}, {0.0, 0.45, -0.15}, 29.0);
  return scene;
}

}  // namespace

SceneEntry fence() {
  return {{.name = "fence",
           .title = "Fence before other objects",
           .description = "The fence alone shadows well. Look at the shadows of wall, crate and "
                          "pot, which hide the ground wholly:\nthe fence's pickets, in front of "
                          "them, let light stripes through.",
           .figure = "Annen 2007, fig. 9",
           .parameters = {{"pickets", "pickets of the fence", 6, 60, 22}}},
          fenceScene};
}

}  // namespace umbra::scenes
