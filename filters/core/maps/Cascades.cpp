#include "filters/core/maps/Cascades.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace umbra {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A window's side grows in steps, four to a doubling.
constexpr double stepsPerOctave = 4.0;
// Where the camera stands among the bounds, the logarithmic cut cannot begin at distance 0, whose
// logarithm is infinite. It begins at this part of the range: nobody looks at details from nearer.
constexpr double nearestPart = 0.01;
// The smallest side of a window. In a window so small, single precision is still exact to
// hundredths of a texel of a map of a thousand texels a side.
constexpr double smallestSide = 1.0 / 256.0;

double stepAbove(double value) {
  return std::exp2(std::ceil(std::log2(value) * stepsPerOctave) / stepsPerOctave);
}
double stepBelow(double value) {
  return value > 0.0 ? std::exp2(std::floor(std::log2(value) * stepsPerOctave) / stepsPerOctave)
                     : 0.0;
}

// What the camera sees, as tangents of the angles from its axis.
struct View {
  View(const Camera& camera, double aspect)
      : position(camera.position), forward((camera.target - camera.position).normalized()) {
    right = forward.cross(camera.up).normalized();
    up = right.cross(forward);
    tangentY = std::tan(0.5 * camera.viewAngle * std::numbers::pi / 180.0);
    tangentX = aspect * tangentY;
  }
  // The squared tangent of the angle between the axis and a corner of the picture.
  double cornerTangent2() const { return tangentX * tangentX + tangentY * tangentY; }

  Vector3d position, forward, right, up;
  double tangentX = 0.0, tangentY = 0.0;
};

struct Range {
  double near = 0.0, far = 0.0;
};

// The distances along the axis between which the view holds parts of the bounds, however the camera
// turns about its position.
Range rangeOf(const View& view, const Eigen::AlignedBox3d& bounds) {
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
    farthest = std::max(
        farthest, (bounds.corner(Eigen::AlignedBox3d::CornerType(corner)) - view.position).norm());
  // Towards the picture's corners a point's distance along the axis is shorter than to the camera.
  const double nearest =
      bounds.exteriorDistance(view.position) / std::sqrt(1.0 + view.cornerTangent2());
  const Range range{stepBelow(nearest), stepAbove(std::max(farthest, 1e-9))};
  return range.near < nearestPart * range.far ? Range{0.0, range.far} : range;
}

struct Sphere {
  Vector3d centre = Vector3d::Zero();
  double radius = 0.0;
};

// The smallest sphere about a part of the view, with its centre on the view's axis. Its radius and
// its distance from the camera do not change as the camera turns.
Sphere sphereAbout(const View& view, const Range& part) {
  const double t2 = view.cornerTangent2();
  const double middle = std::min(part.far, 0.5 * (part.near + part.far) * (1.0 + t2));
  const auto toCorner = [&](double distance) {
    return std::hypot(distance - middle, std::sqrt(t2) * distance);
  };
  return {view.position + middle * view.forward, std::max(toCorner(part.near), toCorner(part.far))};
}

std::array<Vector3d, 8> cornersOf(const View& view, const Range& part) {
  std::array<Vector3d, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const double distance = i < 4 ? part.near : part.far;
    const double x = i % 4 == 1 || i % 4 == 2 ? 1.0 : -1.0, y = i % 4 >= 2 ? 1.0 : -1.0;
    corners[std::size_t(i)] =
        view.position +
        distance * (view.forward + x * view.tangentX * view.right + y * view.tangentY * view.up);
  }
  return corners;
}

// A square part of the whole map, in the whole map's (u, v).
struct Window {
  Vector2d centre = Vector2d::Constant(0.5);
  double side = std::numeric_limits<double>::infinity();  // infinite: the whole map
};

Window windowAbout(const Sphere& sphere, const LightFrame& light) {
  const LightPoint centre = light.project(sphere.centre);
  // From −1 to 1 clip space is as wide as the map.
  return {{centre.u, centre.v}, sphere.radius * std::abs(light.lightToClip(0, 0))};
}

// A spot light enlarges what is near to it, so that a sphere does not keep its size on the map: the
// window follows the corners of the part. Points outside the cone's square are not lit and need no
// room.
Window windowAbout(const std::array<Vector3d, 8>& corners, const LightFrame& light) {
  Eigen::AlignedBox2d box;
  for (const Vector3d& corner : corners) {
    const Vector3d point = (light.worldToLight * corner.homogeneous()).head<3>();
    if (-point.z() <= 0.0) return {};  // the part reaches behind the light
    const LightPoint projected = light.project(corner);
    box.extend(Vector2d(projected.u, projected.v));
  }
  box = box.intersection(Eigen::AlignedBox2d(Vector2d::Zero(), Vector2d::Ones()));
  if (box.isEmpty()) return {};
  return {box.center(), box.sizes().maxCoeff()};
}

void place(Cascade& cascade, const Window& window, bool inSteps, int size, int reach) {
  // A texel more than the reach, since the window moves by whole ones.
  const double around = std::min(reach + 1, size / 4);
  double side = std::max(window.side * size / (size - 2.0 * around), smallestSide);
  if (inSteps) side = stepAbove(side);
  if (!(side < 1.0)) return;
  const double texel = side / size;
  cascade.side = side;
  cascade.left = std::floor((window.centre.x() - 0.5 * side) / texel) * texel;
  cascade.top = std::floor((window.centre.y() - 0.5 * side) / texel) * texel;
  // Clip coordinates of the window from those of the whole frame, before the division by w.
  Eigen::Matrix4d& clip = cascade.frame.lightToClip;
  const Eigen::RowVector4d w = clip.row(3);
  clip.row(0) = clip.row(0) / side + ((1.0 - 2.0 * cascade.left) / side - 1.0) * w;
  clip.row(1) = clip.row(1) / side + ((1.0 - 2.0 * cascade.top) / side - 1.0) * w;
}

}  // namespace

std::vector<double> practicalSplits(double near, double far, int count, double lambda) {
  std::vector<double> ends(std::size_t(count) + 1);
  for (int i = 0; i <= count; ++i) {
    const double part = double(i) / count;
    ends[std::size_t(i)] =
        lambda * near * std::pow(far / near, part) + (1.0 - lambda) * (near + (far - near) * part);
  }
  ends.front() = near;
  ends.back() = far;
  return ends;
}

std::vector<Cascade> fitCascades(const LightFrame& light, const Camera& camera, double aspect,
                                 const Eigen::AlignedBox3d& bounds, const MapSettings& map,
                                 int reach) {
  const View view(camera, aspect);
  const Range range = rangeOf(view, bounds);
  const int count = map.cascades.count;
  std::vector<double> ends = practicalSplits(std::max(range.near, nearestPart * range.far),
                                             range.far, count, map.cascades.splitLambda);
  ends.front() = range.near;
  std::vector<Cascade> cascades;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    Cascade cascade;
    cascade.nearDistance = ends[i];
    cascade.farDistance = ends[i + 1];
    cascade.frame = light;
    // The part begins with the seam before it, where this cascade is read already.
    const double begin = i == 0 ? ends[0] : cascades.back().seamDistance(map.cascades.seam);
    const Range part{begin, ends[i + 1]};
    if (count > 1) {
      const bool spot = light.kind == LightKind::Spot;
      const Window window = spot ? windowAbout(cornersOf(view, part), light)
                                 : windowAbout(sphereAbout(view, part), light);
      place(cascade, window, spot, map.size, reach);
    }
    cascades.push_back(cascade);
  }
  return cascades;
}

std::array<Vector3d, 8> viewCorners(const Camera& camera, double aspect, double near, double far) {
  return cornersOf(View(camera, aspect), {near, far});
}

}  // namespace umbra
