#include "datasets/scenes/Teapot.h"

#include <array>
#include <cmath>
#include <numbers>

namespace umbra::scenes {
namespace {

using Cubic = std::array<Vector2d, 4>;

Vector2d at(const Cubic& c, double t) {
  const double s = 1.0 - t;
  return s * s * s * c[0] + 3.0 * s * s * t * c[1] + 3.0 * s * t * t * c[2] + t * t * t * c[3];
}

// The outlines are those of Newell's teapot, whose body, lid and foot are Bézier curves turned
// round an axis; radius and height in his units.
constexpr int curveSteps = 14;

std::vector<Vector2d> bodyProfile() {
  std::vector<Vector2d> profile{{0.0, 0.0}, {1.5, 0.0}};
  const Cubic curves[] = {{{{1.5, 0.0}, {1.5, 0.15}, {2.0, 0.45}, {2.0, 0.90}}},
                          {{{2.0, 0.90}, {2.0, 1.35}, {1.75, 1.875}, {1.5, 2.4}}},
                          {{{1.5, 2.4}, {1.4375, 2.53125}, {1.3375, 2.53125}, {1.4, 2.4}}}};
  for (const Cubic& curve : curves)
    for (int i = 1; i <= curveSteps; ++i) profile.push_back(at(curve, double(i) / curveSteps));
  profile.emplace_back(1.3, 2.34);
  profile.emplace_back(0.0, 2.34);
  return profile;
}

std::vector<Vector2d> lidProfile() {
  std::vector<Vector2d> profile{{0.0, 2.36}, {1.3, 2.36}};
  const Cubic curves[] = {{{{1.3, 2.40}, {1.3, 2.55}, {0.4, 2.55}, {0.2, 2.70}}},
                          {{{0.2, 2.70}, {0.0, 2.85}, {0.8, 3.15}, {0.0, 3.15}}}};
  for (const Cubic& curve : curves)
    for (int i = 0; i <= curveSteps; ++i) {
      const Vector2d point = at(curve, double(i) / curveSteps);
      // The knob's neck stays round a rod, so that the surface does not pinch.
      const bool tip = &curve == &curves[1] && i == curveSteps;
      profile.emplace_back(tip ? 0.0 : std::max(point.x(), 0.12), point.y());
    }
  return profile;
}

// A tube along a curve in the x-y plane whose radius goes from `from` to `to`.
Mesh bent(std::span<const Cubic> curves, double from, double to) {
  std::vector<Vector3d> path;
  std::vector<double> radii;
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (int i = c == 0 ? 0 : 1; i <= curveSteps; ++i) {
      const Vector2d point = at(curves[c], double(i) / curveSteps);
      path.emplace_back(point.x(), point.y(), 0.0);
      const double t = (double(c) + double(i) / curveSteps) / double(curves.size());
      radii.push_back(from + (to - from) * std::pow(t, 0.6));
    }
  return tube(path, radii, 24);
}

}  // namespace

Mesh teapot(double height) {
  Mesh mesh = lathe(bodyProfile(), 72);
  append(mesh, lathe(lidProfile(), 72));
  const Cubic spout[] = {{{{1.55, 0.95}, {2.35, 0.85}, {2.30, 1.75}, {3.05, 2.35}}}};
  const Cubic handle[] = {{{{-1.50, 2.05}, {-2.30, 2.10}, {-2.85, 2.05}, {-2.85, 1.60}}},
                          {{{-2.85, 1.60}, {-2.85, 1.10}, {-2.40, 0.75}, {-1.85, 0.60}}}};
  append(mesh, bent(spout, 0.45, 0.20));
  append(mesh, bent(handle, 0.15, 0.15));
  return transformed(mesh, Eigen::Affine3d(Eigen::Scaling(height / 3.15)));
}

}  // namespace umbra::scenes
