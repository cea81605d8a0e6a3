// The one light that casts shadows, and the frame in which its shadow map is drawn.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string_view>

namespace umbra {

enum class LightKind { Directional, Spot };

// Positions and targets lie within ± this. Beyond it, the single precision of the GPU is too coarse
// for any scene.
inline constexpr double largestCoordinate = 1e9;

struct Light {
  static constexpr double smallestHalfAngle = 1.0, largestHalfAngle = 60.0;
  static constexpr double largestIntensity = 1000.0;

  LightKind kind = LightKind::Directional;
  Eigen::Vector3d position{0.0, 10.0,
                           0.0};          // world; a directional light shines from it to `target`
  Eigen::Vector3d target{0.0, 0.0, 0.0};  // world
  double halfAngle = 30.0;  // degrees from the axis to the cone's edge, within the range above
  Eigen::Vector3d colour{1.0, 1.0, 1.0};  // linear RGB, each 0 … 1
  double intensity = 1.0;

  bool operator==(const Light&) const = default;
};

// Where a world point falls in the shadow map.
struct LightPoint {
  double u = 0.0, v = 0.0;  // in [0,1] inside the map, from its top-left corner, v down
  double z = 0.0;           // linear depth in [0,1] between near and far plane
  bool inside = false;      // u, v in [0,1] and in front of the light
};

// Projection onto the map. `worldToClip` has y turned round against OpenGL's habit: clip y = −1 is
// the map's top row, so that row 0 of every shadow-map texture is the top row, on the GPU as in an
// EXR file, and no read-back is ever flipped. A pass that culls faces must count the winding
// round for that reason.
struct LightFrame {
  LightKind kind = LightKind::Directional;
  Eigen::Matrix4d worldToLight = Eigen::Matrix4d::Identity();  // looks along −z, right-handed
  Eigen::Matrix4d lightToClip = Eigen::Matrix4d::Identity();   // with y turned round
  Eigen::Vector3d position = Eigen::Vector3d::Zero();          // world
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitY();       // world, unit, away from the light
  double nearDistance = 0.0, farDistance = 1.0;                // world units

  Eigen::Matrix4d worldToClip() const { return lightToClip * worldToLight; }
  // Distance of a world point: to the light's plane (directional) or to the light (spot).
  double distance(const Eigen::Vector3d& world) const;
  LightPoint project(const Eigen::Vector3d& world) const;
  // The world point at (u, v) of the map and linear depth z: the inverse of `project`.
  Eigen::Vector3d unproject(double u, double v, double z) const;
};

// Whether a scene has the same depths in both frames, wherever a directional light stands.
bool drawSameDepths(const LightFrame& a, const LightFrame& b);

// The tightest frame of `light` that holds all of `bounds` (world): a directional light's square
// map covers the box, a spot light's covers its cone; near and far plane enclose the box with a
// margin of 2 % of its depth. Throws BadInput when the light has no direction or an empty box.
LightFrame fitLightFrame(const Light& light, const Eigen::AlignedBox3d& bounds);

// Throws BadInput for a light that cannot shine: a position equal to the target, an angle, colour
// or intensity out of range, a coordinate that is not finite or out of reach. `where` is what the
// message begins with: an option, or a file and key.
void validate(const Light& light, std::string_view where);

std::string_view nameOf(LightKind kind);

namespace detail {

// Throws BadInput unless low ≤ value ≤ high; "WHERE: NAME is VALUE, it should be …".
void validateNumber(double value, double low, double high, std::string_view where,
                    std::string_view name);
// Throws BadInput unless position and target are in reach and differ.
void validateLine(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
                  std::string_view where);

}  // namespace detail

}  // namespace umbra
