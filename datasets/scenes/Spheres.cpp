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

// The spheres are placed along the light's rays, so that the heights do not decide which shadows
// overlap.
Vector3d centreOf(const Ball& ball, double height) {
  return Vector3d(ball.x, 0.0, ball.z) + height / lightAt.y() * lightAt;
}

Scene spheresScene(const Values& values) {
  using namespace colours;
  Scene scene;
  const Ball low[] = {{-0.55, 0.45, 0.55, 0.50, paper}, {0.95, 0.75, 0.50, 0.46, sand},
                      {0.55, -0.65, 0.52, 0.48, paper}, {-1.25, -0.75, 0.46, 0.42, sand},
                      {-0.30, 1.55, 0.42, 0.38, sand},  {1.75, -0.10, 0.42, 0.38, paper}};
  const Ball high[] = {{-0.35, 0.70, 2.60, 0.30, teal},   {-0.85, 0.35, 3.20, 0.26, rose},
                       {1.20, 0.65, 2.90, 0.28, ochre},   {0.75, 1.02, 3.50, 0.22, blue},
                       {0.78, -0.50, 3.20, 0.26, brick},  {0.35, -0.85, 2.50, 0.24, teal},
                       {-1.10, -0.60, 3.00, 0.25, slate}, {-0.15, 1.70, 3.40, 0.22, ochre},
                       {1.85, 0.05, 2.70, 0.22, rose}};
  int count = 0;
  const auto add = [&](const Ball& ball, double height) {
    scene.objects.push_back(object("sphere " + std::to_string(++count),
                                   sphere(centreOf(ball, height), ball.radius, 64), ball.colour));
    scene.objects.back().material.specular = 0.25;
  };
  for (const Ball& ball : low) add(ball, ball.height);
  for (const Ball& ball : high) add(ball, ball.height * values.at("lift"));
  addGround(scene, {0.0, 0.0, 0.1}, 2.45, 2.2, stone, slate);
  scene.light = sun(lightAt);
  scene.camera = lookFrom({3.2, 4.3, 7.2}, {-0.6, 1.45, -0.1}, 34.0);
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
          spheresScene};
}

}  // namespace umbra::scenes
