// A small car, closed and low over the ground, for the shadows where things touch.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/meshes/MeshNormals.h"
#include "datasets/scenes/Scenes.h"

namespace umbra::scenes {
namespace {

// One cross-section of the body at x: `low` and `high` in y, half widths at sill, waist and top.
struct Section {
  double x, low, waist, high, sill, belt, top;
};

// From nose to tail; the greenhouse rises between bonnet and boot.
constexpr Section sections[] = {
    {-2.05, 0.38, 0.48, 0.56, 0.50, 0.56, 0.48}, {-2.00, 0.28, 0.50, 0.66, 0.64, 0.70, 0.60},
    {-1.85, 0.24, 0.54, 0.72, 0.76, 0.80, 0.68}, {-1.55, 0.22, 0.60, 0.79, 0.81, 0.85, 0.72},
    {-1.10, 0.22, 0.64, 0.86, 0.83, 0.87, 0.74}, {-0.78, 0.22, 0.66, 0.92, 0.84, 0.88, 0.72},
    {-0.40, 0.22, 0.70, 1.18, 0.84, 0.88, 0.66}, {-0.05, 0.22, 0.74, 1.36, 0.84, 0.88, 0.60},
    {0.35, 0.22, 0.76, 1.41, 0.84, 0.88, 0.59},  {0.80, 0.22, 0.77, 1.38, 0.84, 0.88, 0.58},
    {1.15, 0.22, 0.78, 1.27, 0.84, 0.88, 0.60},  {1.50, 0.22, 0.78, 1.05, 0.83, 0.87, 0.66},
    {1.75, 0.23, 0.76, 0.92, 0.81, 0.84, 0.70},  {1.95, 0.27, 0.70, 0.87, 0.74, 0.77, 0.66},
    {2.02, 0.36, 0.62, 0.80, 0.62, 0.66, 0.56}};

// Interpolates sections between the given ones by Catmull and Rom's spline.
Section between(double position) {
  const int count = int(std::size(sections)), i = std::min(int(position), count - 2);
  const double t = position - i;
  const Section& a = sections[std::max(i - 1, 0)];
  const Section& b = sections[i];
  const Section& c = sections[i + 1];
  const Section& d = sections[std::min(i + 2, count - 1)];
  const auto blend = [&](double Section::*m) {
    return b.*m + 0.5 * t *
                      (c.*m - a.*m +
                       t * (2 * a.*m - 5 * b.*m + 4 * c.*m - d.*m +
                            t * (3 * (b.*m - c.*m) + d.*m - a.*m)));
  };
  return {blend(&Section::x),    blend(&Section::low),  blend(&Section::waist),
          blend(&Section::high), blend(&Section::sill), blend(&Section::belt),
          blend(&Section::top)};
}

// The outline runs from the middle of the floor over the right side, and is mirrored for the left
// one.
std::vector<Vector2d> outlineOf(const Section& s) {
  std::vector<Vector2d> half{{0.5 * s.sill, s.low}, {0.92 * s.sill, s.low}};
  for (int i = 0; i <= 6; ++i) {  // from sill to waist
    const double t = i / 6.0;
    half.emplace_back(s.sill + (s.belt - s.sill) * std::sin(0.5 * std::numbers::pi * t),
                      s.low + 0.05 + t * (s.waist - s.low - 0.05));
  }
  const double shoulder = 0.10 * (s.high - s.waist);
  for (int i = 1; i <= 6; ++i) {  // from waist to the roof's edge
    const double t = i / 6.0;
    half.emplace_back(s.belt - 0.04 * t + (s.top - s.belt + 0.04) * t * t,
                      s.waist + t * (s.high - s.waist - shoulder));
  }
  for (int i = 1; i <= 5; ++i)  // over the roof's edge to its middle
    half.emplace_back(s.top * std::cos(0.5 * std::numbers::pi * i / 6.0),
                      s.high - shoulder + shoulder * std::sin(0.5 * std::numbers::pi * i / 6.0));
  std::vector<Vector2d> outline = half;
  outline.emplace_back(0.0, s.high);
  for (auto p = half.rbegin(); p != half.rend(); ++p) outline.emplace_back(-p->x(), p->y());
  return outline;
}

Mesh body() {
  const int rings = 112;
  std::vector<Eigen::Vector3f> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::uint32_t around = 0;
  for (int ring = 0; ring <= rings; ++ring) {
    const Section s = between(double(ring) * (std::size(sections) - 1) / rings);
    const std::vector<Vector2d> outline = outlineOf(s);
    around = std::uint32_t(outline.size());
    for (const Vector2d& p : outline) points.push_back(Vector3d(s.x, p.y(), p.x()).cast<float>());
  }
  for (std::uint32_t ring = 0; ring < std::uint32_t(rings); ++ring)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = ring * around + i, b = ring * around + (i + 1) % around;
      triangles.push_back({a, a + around, b + around});
      triangles.push_back({a, b + around, b});
    }
  // Fans about the middle close nose and tail.
  for (bool tail : {false, true}) {
    const std::uint32_t base = tail ? std::uint32_t(rings) * around : 0;
    const Section& s = sections[tail ? std::size(sections) - 1 : 0];
    points.push_back(Eigen::Vector3f(float(s.x), float(0.5 * (s.low + s.high)), 0.0f));
    const std::uint32_t middle = std::uint32_t(points.size() - 1);
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = base + i, b = base + (i + 1) % around;
      if (tail)
        triangles.push_back({middle, b, a});
      else
        triangles.push_back({middle, a, b});
    }
  }
  return withNormals(points, triangles, 35.0);
}

struct Wheels {
  Mesh tyres, rims;
};

Wheels wheels() {
  Wheels result;
  for (double x : {-1.28, 1.26})
    for (double side : {-1.0, 1.0}) {
      const Vector3d centre(x, 0.31, side * 0.80), out(0.0, 0.0, side);
      append(result.tyres, torus(centre, out, 0.215, 0.095, 64, 20));
      append(result.rims, cylinder(centre - 0.06 * out, centre + 0.05 * out, 0.16, 0.15, 48));
      append(result.rims, cylinder(centre, centre + 0.075 * out, 0.05, 0.04, 24));
    }
  return result;
}

// Dark panes a little outside the body's flanks, as flat as real ones.
Mesh windows() {
  Mesh mesh;
  const Vector2d front[] = {{-0.66, 0.90}, {0.08, 0.90}, {0.08, 1.28}, {-0.16, 1.26}};
  const Vector2d rear[] = {{0.16, 0.90}, {1.22, 0.90}, {1.00, 1.22}, {0.70, 1.28}, {0.16, 1.29}};
  // They lean inwards as the greenhouse does.
  const Eigen::Affine3d lean =
      moved({0.0, 0.90, 0.90}) * turned(-27.0, Vector3d::UnitX()) * moved({0.0, -0.90, 0.0});
  const auto add = [&](std::span<const Vector2d> outline) {
    const Mesh pane = transformed(extruded(outline, -0.03, 0.0), lean);
    append(mesh, pane);
    append(mesh, transformed(pane, moved({0.28, 0.0, 0.0}) * turned(180.0) * moved({-0.28, 0, 0})));
  };
  add(front);
  add(rear);
  return mesh;
}

Mesh lamps() {
  Mesh mesh;
  for (double side : {-0.52, 0.52}) {
    append(mesh, sphere({-1.93, 0.56, side}, 0.11, 32));
    append(mesh, sphere({1.95, 0.70, 0.98 * side}, 0.09, 32));
  }
  return mesh;
}

// A thin canopy on posts, whose slats throw stripes on the car.
Mesh canopy(int slats) {
  Mesh mesh;
  const double low = -2.3, high = 2.3, top = 2.55;
  for (int i = 0; i < slats; ++i) {
    const double x = low + (high - low) * (i + 0.5) / slats;
    append(mesh, box({x - 0.03, top, -1.35}, {x + 0.03, top + 0.10, 1.35}));
  }
  for (double z : {-1.2, 1.2}) {
    append(mesh, box({low - 0.1, top - 0.12, z - 0.05}, {high + 0.1, top, z + 0.05}));
    for (double x : {low, high})
      append(mesh, box({x - 0.05, 0.0, z - 0.05}, {x + 0.05, top - 0.12, z + 0.05}));
  }
  return mesh;
}

Scene carScene(const Values& values) {
  using namespace colours;
  Scene scene;
  const double lift = values.at("lift");
  const auto place = [&](const Mesh& mesh) { return transformed(mesh, moved({0.0, lift, 0.0})); };
  const Wheels round = wheels();
  scene.objects = {object("body", place(body()), teal),
                   object("windows", place(windows()), iron),
                   object("lamps", place(lamps()), white),
                   object("tyres", place(round.tyres), iron),
                   object("rims", place(round.rims), paper),
                   object("canopy", canopy(int(values.at("slats"))), wood)};
  for (std::size_t i : {0u, 1u}) {
    scene.objects[i].material.specular = 0.4;
    scene.objects[i].material.shininess = 40.0;
  }
  addGround(scene, {0.1, 0.0, 0.35}, 2.75, 2.1, stone, lawn);
  scene.light = sun({-1.6, 7.0, -2.6}, {0.0, 0.4, 0.0});
  scene.camera = lookFrom({-2.6, 2.5, 7.3}, {0.05, 0.95, 0.1}, 30.0);
  return scene;
}

}  // namespace

SceneEntry car() {
  return {{.name = "car",
           .title = "Car under a slatted canopy",
           .description = "With VSM the canopy's slats shine through the body into the shadow "
                          "beneath it. With ESM that shadow\nstays dark: look instead at the tyres "
                          "under the wings and at the slats' edges on the flank, which pale.",
           .figure = "Gumbau 2011, table 1",
           .parameters = {{"lift", "height of the wheels over the ground", 0.0, 1.0, 0.0},
                          {"slats", "slats of the canopy", 0, 40, 18}}},
          carScene};
}

}  // namespace umbra::scenes
