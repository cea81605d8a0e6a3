// Flat occluders at known depths: the two cases that have a closed form.
#include "datasets/scenes/Scenes.h"

namespace umbra::scenes {
namespace {

// The posts reach from the ground to `postHeight` and fix the light's frame whatever the depths of
// the plates are, so that a plate at parameter z lies at normalised depth z: the frame adds 2 % of
// the height on either side.
constexpr double postHeight = 3.2, halfWidth = 2.0, plateThickness = 0.02;

double heightAt(double z) {
  return postHeight * (1.02 - 1.04 * z);
}

// A horizontal plate, whose upper side lies at normalised depth z.
Mesh plate(double z, double lowX, double highX, double lowZ, double highZ) {
  const double top = heightAt(z);
  return box({lowX, top - plateThickness, lowZ}, {highX, top, highZ});
}

// The posts are thinner below, so that their sides face away from the light. Sides along the
// light's rays would catch noise.
SceneObject posts() {
  Mesh mesh;
  for (double x : {-halfWidth, halfWidth})
    for (double z : {-halfWidth, halfWidth})
      append(mesh, cylinder({x, 0.0, z}, {x, postHeight, z}, 0.012, 0.035, 16));
  return object("posts", std::move(mesh), colours::iron);
}

SceneObject surroundings() {
  SceneObject ground =
      object("ground", box({-60.0, -0.1, -60.0}, {60.0, 0.0, 60.0}), colours::stone);
  ground.boundsLight = false;
  return ground;
}

Scene buildThreePlanes(const Values& values) {
  Scene scene;
  const int slats = int(values.at("slats"));
  const double reach = 1.3, pitch = 2.0 * reach / slats, share = values.at("coverage");
  Mesh blind;
  for (int i = 0; i < slats && share > 0.0; ++i) {
    const double low = -reach + i * pitch;
    append(blind, plate(values.at("a"), low, low + share * pitch, -1.1, 1.7));
  }
  scene.objects = {object("A", std::move(blind), colours::ochre),
                   object("B", plate(values.at("b"), -1.5, 1.5, -1.5, 1.1), colours::teal),
                   object("C", plate(values.at("c"), -2.0, 2.0, -2.0, 2.0), colours::paper),
                   posts(), surroundings()};
  scene.light = sun({0.0, 9.0, 0.0});
  scene.camera = lookFrom({-1.5, 2.5, 8.4}, {0.0, 1.25, 0.0}, 24.5);
  return scene;
}

Scene buildTwoPlanes(const Values& values) {
  Scene scene;
  scene.objects = {
      object("occluder", plate(values.at("occluder"), -1.2, 0.0, -1.2, 1.2), colours::teal),
      object("receiver", plate(values.at("receiver"), -2.0, 2.0, -2.0, 2.0), colours::paper),
      posts(), surroundings()};
  scene.light = sun({0.0, 9.0, 0.0});
  scene.camera = lookFrom({4.6, 4.9, 6.8}, {0.0, 1.1, 0.0}, 28.0);
  return scene;
}

}  // namespace

SceneEntry threePlanes() {
  return {{.name = "three-planes",
           .title = "Three planes, one over another",
           .description = "B shadows C wholly, so C must be dark under it. Look under B: the "
                          "edges of A, high above,\nbleed through it as light stripes, by a "
                          "quarter of the light where A covers half of the region.",
           .figure = "Lauritzen 2008, fig. 3.4",
           .parameters = {{"a", "depth of A, the upper occluder", 0.02, 0.60, 0.12},
                          {"b", "depth of B, the lower occluder", 0.20, 0.90, 0.74},
                          {"c", "depth of C, the receiver", 0.30, 0.97, 0.94},
                          {"coverage", "share of each slat's pitch that A covers", 0.0, 1.0, 0.5},
                          {"slats", "slats that A consists of; 1 is the figure's one plane", 1, 60,
                           30}},
           .planes = {"a", "b", "c"}},
          buildThreePlanes};
}

SceneEntry twoPlanes() {
  return {{.name = "two-planes",
           .title = "One plane over another",
           .description = "One flat occluder parallel to a flat receiver. Chebyshev's bound is "
                          "exact here: across the edge\nof the shadow variance shadow maps and "
                          "percentage-closer filtering agree.",
           .figure = "Lauritzen 2008, §3.2",
           .parameters = {{"occluder", "depth of the occluder", 0.02, 0.90, 0.45},
                          {"receiver", "depth of the receiver", 0.10, 0.97, 0.90}},
           .planes = {"occluder", "receiver"}},
          buildTwoPlanes};
}

}  // namespace umbra::scenes
