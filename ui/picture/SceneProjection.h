// Between world points and points of the scene's widget.
#pragma once

#include <Eigen/Core>
#include <QLineF>
#include <QPointF>
#include <QSizeF>
#include <optional>

class vtkRenderer;

namespace umbra {

// A snapshot of the camera: valid until it moves or the widget changes its size. Widget points are
// in logical pixels, y down.
class SceneProjection {
 public:
  SceneProjection() = default;
  SceneProjection(vtkRenderer& renderer, const QSizeF& widget);

  // None behind the camera.
  std::optional<QPointF> toWidget(const Eigen::Vector3d& world) const;
  // The part of a world segment in front of the camera.
  std::optional<QLineF> toWidget(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  // `world` moved by `by` (widget) parallel to the picture.
  Eigen::Vector3d moved(const Eigen::Vector3d& world, const QPointF& by) const;
  QSizeF size() const { return size_; }

 private:
  QPointF fromClip(const Eigen::Vector4d& clip) const;

  Eigen::Matrix4d worldToClip_ = Eigen::Matrix4d::Identity();
  QSizeF size_;  // logical pixels
};

}  // namespace umbra
