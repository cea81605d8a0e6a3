#include "datasets/scenes/Scenes.h"
#include "datasets/scenes/Tree.h"

namespace umbra::scenes {
namespace {

// The bench lies along x and stands on y = 0; the seat's front edge faces +z.
std::pair<Mesh, Mesh> bench() {
  Mesh wood, iron;
  const double half = 0.95, seat = 0.46;
  append(wood, box({-half, seat - 0.05, -0.27}, {half, seat, 0.27}));
  for (int i = 0; i < 3; ++i)
    append(wood, board({0.0, 0.60 + 0.14 * i, -0.30 - 0.035 * i}, {2.0 * half, 0.10, 0.035}, -14.0,
                       Vector3d::UnitX()));
  for (double x : {-0.78, 0.78}) {
    append(iron, board({x, 0.205, 0.20}, {0.07, 0.41, 0.07}));
    append(iron, board({x, 0.205, -0.22}, {0.07, 0.41, 0.07}));
    append(iron, board({x, 0.66, -0.345}, {0.06, 0.56, 0.05}, -14.0, Vector3d::UnitX()));
    append(iron, board({x, 0.385, 0.0}, {0.06, 0.05, 0.48}));
  }
  return {wood, iron};
}

Scene treeBenchScene(const Values&) {
  Scene scene;
  Tree tree = growTree({.height = 3.7, .crown = 1.45, .leaves = 1100, .leafLength = 0.25});
  const Eigen::Affine3d place = moved({-0.75, 0.0, -1.35});
  auto [wood, iron] = bench();
  const Eigen::Affine3d seat = moved({0.15, 0.0, 0.25}) * turned(-8.0);
  scene.objects = {object("trunk", transformed(tree.wood, place), colours::bark),
                   object("leaves", transformed(tree.leaves, place), colours::leaf),
                   object("bench", transformed(wood, seat), colours::wood),
                   object("bench frame", transformed(iron, seat), colours::iron)};
  addGround(scene, {-0.1, 0.0, -0.1}, 2.6, 2.4, colours::sand, colours::lawn);
  scene.light = sun({-2.6, 7.6, -4.2}, {-0.1, 0.5, 0.0});
  scene.camera = lookFrom({1.7, 2.3, 5.2}, {-0.2, 1.15, -0.3}, 36.0);
  return scene;
}

}  // namespace

SceneEntry treeBench() {
  return {{.name = "tree-bench",
           .title = "Tree over a bench",
           .description = "The seat shadows the ground beneath it wholly. Look there: the edges "
                          "of the leaves' shadows, far above,\nshow through the seat as bright "
                          "spots that move with the filter's size.",
           .figure = "Lauritzen 2008, fig. 3.5",
           .parameters = {}},
          treeBenchScene};
}

}  // namespace umbra::scenes
