// Spheres that float over each other: their shadows overlap on the ground.
#include "datasets/scenes/Scenes.h"

namespace umbra::scenes {
namespace {

const Vector3d lightAt{-4.6, 8.0, -2.6};

struct Ball {
  double x, z;  // where its shadow's centre falls on the ground
  double height, radius;
  Vector3d colour;
};

// Placed along the light's rays, so that which shadows overlap does not depend on the heights.
Vector3d centreOf(const Ball& ball, double height) {
  return Vector3d(ball.x, 0.0, ball.z) + height / lightAt.y() * lightAt;
}

Scene build(const Values& values) {
  using namespace colours;
  Scene scene;
  const Ball low[] = {{-0.75, 0.35, 0.80, 0.72, paper},
                      {1.35, 0.75, 0.66, 0.60, sand},
                      {0.55, -1.05, 0.60, 0.55, paper},
                      {-1.75, -1.15, 0.50, 0.45, sand}};
  const Ball high[] = {{-0.30, 0.75, 2.60, 0.40, teal},   {-1.15, 0.05, 3.30, 0.32, rose},
                       {1.70, 0.45, 2.90, 0.34, ochre},   {1.00, 1.10, 3.60, 0.28, blue},
                       {0.85, -0.80, 3.20, 0.30, brick},  {0.15, -1.35, 2.50, 0.26, teal},
                       {-1.50, -0.90, 3.00, 0.27, slate}, {0.35, 0.10, 3.70, 0.24, ochre}};
  int count = 0;
  const auto add = [&](const Ball& ball, double height) {
    scene.objects.push_back(object("sphere " + std::to_string(++count),
                                   sphere(centreOf(ball, height), ball.radius, 64), ball.colour));
    scene.objects.back().material.specular = 0.25;
  };
  for (const Ball& ball : low) add(ball, ball.height);
  for (const Ball& ball : high) add(ball, ball.height * values.at("lift"));
  addGround(scene, {-0.1, 0.0, -0.1}, 2.7, 2.3, stone, slate);
  scene.light = sun(lightAt);
  scene.camera = lookFrom({4.6, 4.2, 8.0}, {-0.75, 1.45, -0.3}, 34.0);
  return scene;
}

}  // namespace

SceneEntry spheres() {
  return {{.name = "spheres",
           .title = "Spheres over spheres",
           .description = "Each large sphere shadows the ground wholly, and small ones float high "
                          "above it on the same rays. Look\ninto the large shadows: the small "
                          "spheres' outlines shine through as bright rings.",
           .figure = "Gumbau 2011, fig. 3",
           .parameters = {{"lift", "height of the small spheres, as a multiple", 0.5, 1.3, 1.0}}},
          build};
}

}  // namespace umbra::scenes
