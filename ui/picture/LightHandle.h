// The sun of the scene that one can take hold of.
#pragma once

#include <QPointF>
#include <optional>

#include "filters/core/scene/Light.h"
#include "ui/picture/SceneProjection.h"

namespace umbra {

// The handle stands at the light; where that is out of the picture, at the last point towards it
// that is in the picture.
class LightHandle {
 public:
  // `anchor` (world) is the point whose ray to the light is drawn: the probe's, or the target.
  void place(const Light& light, const Eigen::Vector3d& anchor, const SceneProjection& projection);

  // Widget, logical pixels; none where the picture shows no part of the way to the light.
  std::optional<QPointF> position() const { return position_; }
  // World, where the handle is drawn.
  const Eigen::Vector3d& world() const { return world_; }
  bool isAt(const QPointF& point) const;

  // The light with the handle moved by `by`: a directional light turns about its target at its
  // distance, a spot light moves parallel to the picture.
  Light dragged(const Light& light, const QPointF& by, const SceneProjection& projection) const;

 private:
  std::optional<QPointF> position_;
  Eigen::Vector3d world_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d anchor_ = Eigen::Vector3d::Zero();
  double share_ = 1.0;  // of the way from the anchor to the light
};

}  // namespace umbra
