// The first hits of a light's rays: the scene's casters without a shadow map in between (Wald et
// al. 2014, "Embree: A Kernel Framework for Efficient CPU Ray Tracing").
#pragma once

#include <memory>

#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"

namespace umbra {

// The rays of a light's frame, one for each position (u, v) of its map. The rays of a directional
// light are parallel and begin before every caster; those of a spot light begin at the light.
struct LightRays {
  LightKind kind = LightKind::Directional;
  // Directional: the origin at (0, 0), and how it moves with u and v. Spot: the direction at (0,
  // 0), of length 1 along the light's axis, and how it changes with u and v. World.
  Eigen::Vector3d first, perU, perV;
  Eigen::Vector3d fixed;  // directional: the direction, unit; spot: the origin
  double lead = 0.0;      // directional: origins lie this far before the near plane, world units
  double nearDistance = 0.0, farDistance = 1.0;
};

// Casts are const and may run on many threads at once.
class CasterRays {
 public:
  // Every object casts shadows. `cullFrontFaces` leaves out faces towards the light, as in Bias.
  // Throws WorkFailed where the tracer cannot be set up.
  CasterRays(const Scene& scene, bool cullFrontFaces);
  ~CasterRays();
  CasterRays(CasterRays&&) noexcept;
  CasterRays& operator=(CasterRays&&) noexcept;

  LightRays raysOf(const LightFrame& frame) const;

  // The linear depth of the first hit of the ray through (u, v), which a map of unlimited
  // resolution holds there. It is 0 before the near plane, and 1 behind the far plane and where
  // there is no hit. It is computed in single precision, exact to a few 1e-7 of the ray's length.
  double depth(const LightRays& rays, double u, double v) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace umbra
