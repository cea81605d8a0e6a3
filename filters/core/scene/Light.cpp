#include "filters/core/scene/Light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "filters/core/support/Error.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

Matrix4d lookAlong(const Vector3d& from, const Vector3d& direction) {
  // Any up vector serves; the world's y axis keeps the map upright for most lights.
  const Vector3d hint = std::abs(direction.y()) > 0.99 ? Vector3d::UnitZ() : Vector3d::UnitY();
  const Vector3d right = direction.cross(hint).normalized();
  const Vector3d up = right.cross(direction);
  Matrix4d view = Matrix4d::Identity();
  view.block<1, 3>(0, 0) = right.transpose();
  view.block<1, 3>(1, 0) = up.transpose();
  view.block<1, 3>(2, 0) = -direction.transpose();
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * from;
  return view;
}

// Maps light-space x, y in [centre ± half] and −z in [near, far] to the clip cube; y is turned
// round.
Matrix4d orthographic(double centreX, double centreY, double half, double near, double far) {
  Matrix4d m = Matrix4d::Identity();
  m(0, 0) = 1.0 / half;
  m(0, 3) = -centreX / half;
  m(1, 1) = -1.0 / half;
  m(1, 3) = centreY / half;
  m(2, 2) = -2.0 / (far - near);
  m(2, 3) = -(far + near) / (far - near);
  return m;
}

Matrix4d perspective(double halfAngle, double near, double far) {
  const double cotangent = 1.0 / std::tan(halfAngle);
  Matrix4d m = Matrix4d::Zero();
  m(0, 0) = cotangent;
  m(1, 1) = -cotangent;
  m(2, 2) = -(far + near) / (far - near);
  m(2, 3) = -2.0 * far * near / (far - near);
  m(3, 2) = -1.0;
  return m;
}

}  // namespace

double LightFrame::distance(const Vector3d& world) const {
  return kind == LightKind::Directional ? (world - position).dot(direction)
                                        : (world - position).norm();
}

LightPoint LightFrame::project(const Vector3d& world) const {
  const Eigen::Vector4d clip = worldToClip() * world.homogeneous();
  LightPoint point;
  point.z = (distance(world) - nearDistance) / (farDistance - nearDistance);
  if (clip.w() <= 0.0) return point;
  point.u = 0.5 + 0.5 * clip.x() / clip.w();
  point.v = 0.5 + 0.5 * clip.y() / clip.w();
  point.inside = point.u >= 0.0 && point.u <= 1.0 && point.v >= 0.0 && point.v <= 1.0;
  return point;
}

Vector3d LightFrame::unproject(double u, double v, double z) const {
  const double d = nearDistance + z * (farDistance - nearDistance);
  const double clipX = 2.0 * u - 1.0, clipY = 2.0 * v - 1.0;
  Vector3d light;
  if (kind == LightKind::Directional) {
    light = {(clipX - lightToClip(0, 3)) / lightToClip(0, 0),
             (clipY - lightToClip(1, 3)) / lightToClip(1, 1), -d};
  } else {
    const Vector3d ray((clipX + lightToClip(0, 2)) / lightToClip(0, 0),
                       (clipY + lightToClip(1, 2)) / lightToClip(1, 1), -1.0);
    light = d * ray.normalized();
  }
  return (worldToLight.inverse() * light.homogeneous()).head<3>();
}

bool drawSameDepths(const LightFrame& a, const LightFrame& b) {
  return a.kind == b.kind && a.worldToLight == b.worldToLight && a.lightToClip == b.lightToClip &&
         a.nearDistance == b.nearDistance && a.farDistance == b.farDistance;
}

LightFrame fitLightFrame(const Light& light, const Eigen::AlignedBox3d& bounds) {
  const Vector3d axis = light.target - light.position;
  if (!(axis.norm() > 0.0)) throw Error(ErrorKind::BadInput, "light: position and target coincide");
  if (bounds.isEmpty()) throw Error(ErrorKind::BadInput, "light: the scene is empty");
  LightFrame frame;
  frame.kind = light.kind;
  frame.position = light.position;
  frame.direction = axis.normalized();
  frame.worldToLight = lookAlong(light.position, frame.direction);

  Eigen::AlignedBox3d box;  // the scene's bounds in light space
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d world = bounds.corner(Eigen::AlignedBox3d::CornerType(corner));
    box.extend((frame.worldToLight * world.homogeneous()).head<3>());
    farthest = std::max(farthest, (world - light.position).norm());
  }
  nearest = bounds.exteriorDistance(light.position);

  if (light.kind == LightKind::Directional) {
    const double margin = 0.02 * std::max(box.sizes().z(), 1e-9);
    frame.nearDistance = -box.max().z() - margin;
    frame.farDistance = -box.min().z() + margin;
    const double half = 0.5 * 1.01 * std::max({box.sizes().x(), box.sizes().y(), 1e-9});
    const Vector3d centre = box.center();
    frame.lightToClip =
        orthographic(centre.x(), centre.y(), half, frame.nearDistance, frame.farDistance);
  } else {
    // Inside the scene's box nothing bounds the nearest occluder: a thousandth of the reach is
    // taken instead.
    frame.farDistance = farthest * 1.02;
    frame.nearDistance = std::max(nearest * 0.98, frame.farDistance * 1e-3);
    const double halfAngle =
        std::clamp(light.halfAngle, Light::smallestHalfAngle, Light::largestHalfAngle) *
        std::numbers::pi / 180.0;
    // The clip planes are planes and the depth is a distance along the ray: towards the map's
    // corners a point at the near distance lies nearer to the light's plane.
    const double corner = 1.0 / std::sqrt(1.0 + 2.0 * std::pow(std::tan(halfAngle), 2));
    frame.lightToClip = perspective(halfAngle, frame.nearDistance * corner, frame.farDistance);
  }
  return frame;
}

void detail::validateNumber(double value, double low, double high, std::string_view where,
                            std::string_view name) {
  if (value >= low && value <= high) return;
  throw Error(ErrorKind::BadInput, std::string(where) + ": " + std::string(name) + " is " +
                                       toText(value) + ", it should be from " + shortNumber(low) +
                                       " to " + shortNumber(high));
}

void detail::validateLine(const Vector3d& position, const Vector3d& target,
                          std::string_view where) {
  for (int i = 0; i < 3; ++i) {
    validateNumber(position[i], -largestCoordinate, largestCoordinate, where, "the position");
    validateNumber(target[i], -largestCoordinate, largestCoordinate, where, "the target");
  }
  if (!((target - position).norm() > 0.0))
    throw Error(ErrorKind::BadInput, std::string(where) +
                                         ": position and target are the same point, they should "
                                         "differ");
}

void validate(const Light& light, std::string_view where) {
  detail::validateLine(light.position, light.target, where);
  detail::validateNumber(light.halfAngle, Light::smallestHalfAngle, Light::largestHalfAngle, where,
                         "the half angle");
  for (double part : light.colour) detail::validateNumber(part, 0.0, 1.0, where, "the colour");
  detail::validateNumber(light.intensity, 0.0, Light::largestIntensity, where, "the intensity");
}

std::string_view nameOf(LightKind kind) {
  return kind == LightKind::Directional ? "directional" : "spot";
}

}  // namespace umbra
