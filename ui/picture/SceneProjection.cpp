#include "ui/picture/SceneProjection.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace umbra {
namespace {

// Points nearer to the camera's plane than this (clip w, world units) count as behind it.
constexpr double nearest = 1e-3;

}  // namespace

SceneProjection::SceneProjection(vtkRenderer& renderer, const QSizeF& widget) : size_(widget) {
  const double aspect = widget.height() > 0 ? widget.width() / widget.height() : 1.0;
  const vtkMatrix4x4* matrix =
      renderer.GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      worldToClip_(row, column) = matrix->GetElement(row, column);
}

QPointF SceneProjection::fromClip(const Eigen::Vector4d& clip) const {
  return {(clip.x() / clip.w() * 0.5 + 0.5) * size_.width(),
          (0.5 - clip.y() / clip.w() * 0.5) * size_.height()};
}

std::optional<QPointF> SceneProjection::toWidget(const Eigen::Vector3d& world) const {
  const Eigen::Vector4d clip = worldToClip_ * world.homogeneous();
  if (clip.w() < nearest) return std::nullopt;
  return fromClip(clip);
}

std::optional<QLineF> SceneProjection::toWidget(const Eigen::Vector3d& from,
                                                const Eigen::Vector3d& to) const {
  Eigen::Vector4d a = worldToClip_ * from.homogeneous(), b = worldToClip_ * to.homogeneous();
  if (a.w() < nearest && b.w() < nearest) return std::nullopt;
  // Clip coordinates are linear along the segment.
  const auto cut = [](Eigen::Vector4d& behind, const Eigen::Vector4d& front) {
    const double t = (nearest - front.w()) / (behind.w() - front.w());
    behind = front + t * (behind - front);
    behind.w() = nearest;
  };
  if (a.w() < nearest) cut(a, b);
  if (b.w() < nearest) cut(b, a);
  return QLineF(fromClip(a), fromClip(b));
}

Eigen::Vector3d SceneProjection::moved(const Eigen::Vector3d& world, const QPointF& by) const {
  Eigen::Vector4d clip = worldToClip_ * world.homogeneous();
  clip.x() += 2.0 * by.x() / size_.width() * clip.w();
  clip.y() -= 2.0 * by.y() / size_.height() * clip.w();
  const Eigen::Vector4d back = worldToClip_.inverse() * clip;
  return back.hnormalized();
}

}  // namespace umbra
