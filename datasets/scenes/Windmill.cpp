// A post mill whose sails turn above its own gallery, steps and fence.
#include <cmath>
#include <numbers>

#include "datasets/scenes/Scenes.h"

namespace umbra::scenes {
namespace {

constexpr double hubHeight = 3.75, hubZ = 0.98, sailLength = 2.25, galleryHeight = 1.25;

// One sail along +y from the hub: a whip with bars and hemlaths, as millers lay cloth over.
Mesh sail() {
  Mesh mesh = box({-0.035, 0.0, -0.035}, {0.035, sailLength, 0.035});
  const double inner = 0.45, wide = 0.52;
  const int bars = 13;
  for (int i = 0; i < bars; ++i) {
    const double y = inner + (sailLength - inner - 0.03) * i / (bars - 1);
    append(mesh, box({-0.10, y - 0.014, -0.012}, {wide, y + 0.014, 0.012}));
  }
  for (double x : {-0.09, 0.14, 0.33, wide})
    append(mesh, box({x - 0.014, inner, -0.03}, {x + 0.014, sailLength, -0.008}));
  return mesh;
}

Mesh sails(double degrees) {
  Mesh mesh = cylinder({0, 0, -0.55}, {0, 0, 0.12}, 0.09, 0.08, 32);
  for (int i = 0; i < 4; ++i)
    append(mesh, transformed(sail(), turned(degrees + 90.0 * i, Vector3d::UnitZ()) *
                                         turned(9.0, Vector3d::UnitY())));
  return transformed(mesh, moved({0.0, hubHeight, hubZ}) * turned(-7.0, Vector3d::UnitX()));
}

Mesh tower() {
  const Vector2d profile[] = {{0.0, 0.0},   {0.98, 0.0},  {0.98, 0.22}, {0.93, 0.24},
                              {0.60, 3.25}, {0.66, 3.28}, {0.66, 3.40}, {0.0, 3.40}};
  return lathe(profile, 16);
}

Mesh cap() {
  std::vector<Vector2d> profile{{0.0, 3.40}, {0.70, 3.40}};
  for (int i = 0; i <= 12; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / 12;
    profile.emplace_back(i == 12 ? 0.0 : 0.70 * std::cos(angle), 3.50 + 0.72 * std::sin(angle));
  }
  return lathe(profile, 48);
}

// The platform round the tower on struts, with a railing.
Mesh gallery() {
  Mesh mesh;
  const int planks = 72, posts = 24;
  const double inner = 0.70, outer = 1.62;
  for (int i = 0; i < planks; ++i) {
    const Mesh plank =
        board({0.0, galleryHeight, 0.5 * (inner + outer)},
              {2.0 * std::numbers::pi * outer / planks - 0.012, 0.05, outer - inner});
    append(mesh, transformed(plank, turned(360.0 * i / planks)));
  }
  for (int i = 0; i < posts; ++i) {
    const Eigen::Affine3d round = turned(360.0 * (i + 0.5) / posts);
    const double y = galleryHeight;
    append(mesh, transformed(box({-0.02, y, outer - 0.07}, {0.02, y + 0.42, outer - 0.03}), round));
    if (i % 2 == 0)
      append(mesh,
             transformed(cylinder({0, 0.62, 0.86}, {0, y, outer - 0.1}, 0.03, 0.03, 12), round));
  }
  for (double y : {0.20, 0.42})
    append(mesh,
           torus({0.0, galleryHeight + y, 0.0}, Vector3d::UnitY(), outer - 0.05, 0.018, 96, 8));
  return mesh;
}

Mesh stair() {
  Mesh mesh;
  const int treads = 8;
  for (int i = 0; i < treads; ++i) {
    const double t = double(i + 1) / (treads + 1);
    append(mesh, board({0.0, t * galleryHeight, 2.55 - 0.95 * t}, {0.60, 0.03, 0.15}));
  }
  for (double x : {-0.31, 0.31}) {
    const Vector3d path[] = {{x, 0.0, 2.58}, {x, galleryHeight, 1.60}};
    const double radii[] = {0.03, 0.03};
    append(mesh, tube(path, radii, 8));
  }
  return mesh;
}

// Sacks and barrels in the gallery's shade.
Mesh barrels() {
  const Vector2d profile[] = {{0.0, 0.0},   {0.15, 0.0},  {0.19, 0.12}, {0.205, 0.25},
                              {0.19, 0.38}, {0.15, 0.50}, {0.13, 0.50}, {0.0, 0.48}};
  Mesh mesh;
  for (const Vector2d& at : {Vector2d(1.25, 1.15), Vector2d(1.62, 0.85), Vector2d(1.55, 1.30)})
    append(mesh, transformed(lathe(profile, 40), moved({at.x(), 0.0, at.y()})));
  return mesh;
}

Scene windmillScene(const Values& values) {
  using namespace colours;
  Scene scene;
  scene.objects = {object("tower", tower(), paper),
                   object("cap", cap(), brick),
                   object("sails", sails(values.at("turn")), wood),
                   object("gallery", gallery(), bark),
                   object("steps", stair(), bark),
                   object("barrels", barrels(), ochre)};
  addGround(scene, {-0.35, 0.0, 0.1}, 2.9, 2.7, sand, lawn);
  scene.light = sun({4.2, 8.6, 4.4}, {0.0, 1.2, 0.0});
  scene.camera = lookFrom({-7.2, 5.2, 8.4}, {-0.55, 2.8, 0.0}, 37.0);
  return scene;
}

}  // namespace

SceneEntry windmill() {
  return {{.name = "windmill",
           .title = "Windmill and its gallery",
           .description = "Sails over railing over gallery over barrels and steps: many shadows "
                          "overlap. Look at the gallery's\nshadow on the ground and at the tower "
                          "behind the sails: the lattice "
                          "of the sails bleeds through what lies between.",
           .figure = "Lauritzen 2008, fig. 4.8",
           .parameters = {{"turn", "degrees that the sails have turned", 0.0, 90.0, 22.0}}},
          windmillScene};
}

}  // namespace umbra::scenes
