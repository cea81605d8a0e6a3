#include "ui/picture/LightHandle.h"

#include <QRectF>
#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

constexpr double margin = 22.0;      // logical pixels to the picture's border
constexpr double grabRadius = 16.0;  // logical pixels

// A directional light's position says no more than its direction, so that its ray may start at
// any point.
Eigen::Vector3d lightAbove(const Light& light, const Eigen::Vector3d& anchor) {
  return light.kind == LightKind::Directional ? anchor + (light.position - light.target)
                                              : light.position;
}

}  // namespace

void LightHandle::place(const Light& light, const Eigen::Vector3d& anchor,
                        const SceneProjection& projection) {
  anchor_ = anchor;
  const Eigen::Vector3d end = lightAbove(light, anchor);
  const QSizeF size = projection.size();
  const QRectF room = QRectF(QPointF(), size).adjusted(margin, margin, -margin, -margin);
  const auto visible = [&](double share) {
    const auto point = projection.toWidget(anchor + share * (end - anchor));
    return point && room.contains(*point);
  };
  position_.reset();
  // The farthest of a hundred steps that is in the picture, then refined between it and the next.
  constexpr int steps = 100;
  int last = steps;
  while (last > 0 && !visible(double(last) / steps)) --last;
  if (last == 0) return;
  double in = double(last) / steps, out = std::min(1.0, in + 1.0 / steps);
  for (int i = 0; i < 16 && last < steps; ++i) {
    const double middle = 0.5 * (in + out);
    (visible(middle) ? in : out) = middle;
  }
  share_ = in;
  world_ = anchor + share_ * (end - anchor);
  position_ = projection.toWidget(world_);
}

bool LightHandle::isAt(const QPointF& point) const {
  return position_ &&
         std::hypot(point.x() - position_->x(), point.y() - position_->y()) < grabRadius;
}

Light LightHandle::dragged(const Light& light, const QPointF& by,
                           const SceneProjection& projection) const {
  const double distance = (light.position - light.target).norm();
  const Eigen::Vector3d end = anchor_ + (projection.moved(world_, by) - anchor_) / share_;
  Light moved = light;
  if (light.kind == LightKind::Spot) {
    moved.position = end;
  } else if (const Eigen::Vector3d way = end - anchor_; way.norm() > 1e-9) {
    moved.position = light.target + distance * way.normalized();
  }
  return moved;
}

}  // namespace umbra
