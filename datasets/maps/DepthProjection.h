// What stands between a depth map's stored values and linear depth: the projection that drew it.
#pragma once

#include <string>
#include <string_view>

namespace umbra {

// A window depth w, from 0 to 1, as OpenGL, Direct3D and Vulkan store it, of a point whose distance
// from the light's plane is z, with the planes near n and far f:
//   perspective        w = f (z − n) / (z (f − n))
//   reversed           w = n (f − z) / (z (f − n)), nearer is larger
//   infinite           w = 1 − n / z
//   reversed infinite  w = n / z
struct DepthProjection {
  enum class Kind { Linear, Perspective, Reversed, Infinite, ReversedInfinite };

  Kind kind = Kind::Linear;
  double near = 0.0, far = 0.0;  // world; far is 0 where the farthest texel gives it
  // Degrees of the light's vertical field of view, where linear depth is to be the distance to the
  // light instead of to its plane; 0 otherwise.
  double euclidAngle = 0.0;

  bool operator==(const DepthProjection&) const = default;

  bool isReversed() const { return kind == Kind::Reversed || kind == Kind::ReversedInfinite; }
  bool isInfinite() const { return kind == Kind::Infinite || kind == Kind::ReversedInfinite; }
  // The distance to the light's plane of a window depth in [0, 1]; infinite where nothing was hit.
  double distance(double window) const;
  // The inverse.
  double window(double distance) const;
};

inline constexpr std::string_view projectionSyntax =
    "linear, perspective:NEAR,FAR, reversed:NEAR,FAR, infinite:NEAR[:FAR] or "
    "reversed-infinite:NEAR[:FAR], each but linear with :euclid,ANGLE";

// As the syntax says; "linear" is its default. Throws BadInput that begins with `where`.
DepthProjection projectionFrom(std::string_view text, std::string_view where);
std::string toText(const DepthProjection& projection);

}  // namespace umbra
