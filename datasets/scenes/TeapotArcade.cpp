// A teapot on a table in an arcade, lit by one lamp through a grille and two rows of arches.
#include <cmath>
#include <numbers>

#include "datasets/scenes/Scenes.h"
#include "datasets/scenes/Teapot.h"

namespace umbra::scenes {
namespace {

constexpr double bay = 1.1, springing = 1.15, thickness = 0.22;
constexpr int bays = 4;

// A row of round arches along x: one outline, from the left foot over each opening in turn.
Mesh arches(double z) {
  const double radius = 0.40, top = 2.0, half = 0.5 * bay * bays;
  std::vector<Vector2d> outline{{-half, top}, {-half, 0.0}};
  for (int i = 0; i < bays; ++i) {
    const double centre = -half + (i + 0.5) * bay;
    outline.emplace_back(centre - radius, 0.0);
    for (int k = 0; k <= 24; ++k) {
      const double angle = std::numbers::pi * (1.0 - k / 24.0);
      outline.emplace_back(centre + radius * std::cos(angle), springing + radius * std::sin(angle));
    }
    outline.emplace_back(centre + radius, 0.0);
  }
  outline.emplace_back(half, 0.0);
  outline.emplace_back(half, top);
  Mesh mesh = extruded(outline, z - 0.5 * thickness, z + 0.5 * thickness);
  append(mesh, box({-half - 0.06, top, z - 0.19}, {half + 0.06, top + 0.12, z + 0.19}));
  return mesh;
}

// Joists over the passage and the court before it, where two posts carry them.
Mesh pergola(int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const double x = -2.1 + 4.2 * (i + 0.5) / count;
    append(mesh, box({x - 0.03, 2.12, -1.9}, {x + 0.03, 2.24, 1.55}));
  }
  append(mesh, box({-2.2, 2.02, 1.37}, {2.2, 2.12, 1.47}));
  for (double x : {-2.1, 2.1})
    append(mesh, cylinder({x, 0.0, 1.42}, {x, 2.02, 1.42}, 0.06, 0.05, 32));
  return mesh;
}

Mesh table() {
  const Vector2d profile[] = {{0.0, 0.0},   {0.36, 0.0},  {0.36, 0.05}, {0.12, 0.11}, {0.07, 0.30},
                              {0.07, 0.52}, {0.14, 0.60}, {0.58, 0.62}, {0.60, 0.66}, {0.0, 0.66}};
  return lathe(profile, 64);
}

Mesh cups() {
  const Vector2d profile[] = {{0.0, 0.0},   {0.05, 0.0},  {0.09, 0.05},  {0.10, 0.12},
                              {0.09, 0.12}, {0.08, 0.06}, {0.04, 0.015}, {0.0, 0.015}};
  Mesh mesh;
  for (const Vector2d& at : {Vector2d(0.42, 0.22), Vector2d(-0.36, 0.28), Vector2d(0.05, 0.47)})
    append(mesh, transformed(lathe(profile, 40), moved({at.x(), 0.66, at.y()})));
  return mesh;
}

Scene arcadeScene(const Values& values) {
  using namespace colours;
  Scene scene;
  const Eigen::Affine3d place = moved({0.3, 0.0, 0.85});
  scene.objects = {
      object("back arches", arches(-1.75), sand),
      object("front arches", arches(-0.20), paper),
      object("pergola", pergola(int(values.at("joists"))), wood),
      object("table", transformed(table(), place), bark),
      object("cups", transformed(cups(), place), white),
      object("teapot",
             transformed(teapot(0.52), place * moved({-0.02, 0.66, -0.05}) * turned(28.0)), teal)};
  scene.objects.back().material.specular = 0.4;
  scene.objects.back().material.shininess = 40.0;
  addGround(scene, {0.1, 0.0, 0.15}, 2.75, 2.45, rose, stone);
  scene.light = sun({-2.3, 7.6, -2.6}, {0.0, 0.5, 0.3});
  scene.light.kind = LightKind::Spot;
  scene.light.halfAngle = 30.0;
  scene.light.intensity = 1.2;
  scene.camera = lookFrom({1.6, 2.5, 6.4}, {0.1, 0.95, 0.3}, 32.0);
  return scene;
}

}  // namespace

SceneEntry teapotArcade() {
  return {{.name = "teapot-arcade",
           .title = "Teapot before an arcade",
           .description = "A worst case: a spot light through arches, joists, teapot and table, "
                          "each before the next. Look under the\ntable and behind the front "
                          "arches: every edge nearer to the light shows through the last one.",
           .figure = "Lauritzen 2008, fig. 4.3",
           .parameters = {{"joists", "joists over the passage", 0, 40, 16}}},
          arcadeScene};
}

}  // namespace umbra::scenes
