#include "ui/widgets/maps/TexelZoom.h"

#include <QWidget>
#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

constexpr double largestScale = 160.0;  // widget pixels per texel
constexpr double shownShare = 2.0 / 3.0;

}  // namespace

void TexelZoom::follow() {
  if (fitted_)
    fit();
  else
    setView(scale_, centre_);
}

void TexelZoom::setView(double scale, const QPointF& centre) {
  const double smallest = std::min({double(widget_.width()) / std::max(map_.width(), 1),
                                    double(widget_.height()) / std::max(map_.height(), 1), 1.0});
  scale_ = std::clamp(scale, smallest, largestScale);
  centre_ = {std::clamp(centre.x(), 0.0, double(map_.width())),
             std::clamp(centre.y(), 0.0, double(map_.height()))};
}

void TexelZoom::fit() {
  fitted_ = true;
  if (map_.isEmpty()) return;
  setView(
      std::min(double(widget_.width()) / map_.width(), double(widget_.height()) / map_.height()),
      {map_.width() / 2.0, map_.height() / 2.0});
}

void TexelZoom::show(const QRect& texels) {
  fitted_ = false;
  const double side = std::max(texels.width(), texels.height());
  setView(shownShare * std::min(widget_.width(), widget_.height()) / side, QRectF(texels).center());
}

void TexelZoom::zoomAbout(const QPointF& point, double factor) {
  const QPointF middle(widget_.width() / 2.0, widget_.height() / 2.0);
  const QPointF under = centre_ + (point - middle) / scale_;
  fitted_ = false;
  setView(scale_ * factor, centre_);
  setView(scale_, under - (point - middle) / scale_);
}

void TexelZoom::pan(const QPointF& by) {
  fitted_ = false;
  setView(scale_, centre_ - by / scale_);
}

double TexelZoom::column(double x) const {
  return std::floor(centre_.x() + (x - widget_.width() / 2.0) / scale_);
}

double TexelZoom::row(double y) const {
  return std::floor(centre_.y() + (y - widget_.height() / 2.0) / scale_);
}

std::optional<QPoint> TexelZoom::texelAt(const QPointF& point) const {
  const double x = column(point.x()), y = row(point.y());
  if (!(x >= 0 && y >= 0 && x < map_.width() && y < map_.height())) return std::nullopt;
  return QPoint(int(x), int(y));
}

QRectF TexelZoom::rectOfTexels(const QRect& texels) const {
  return {widget_.width() / 2.0 + (texels.x() - centre_.x()) * scale_,
          widget_.height() / 2.0 + (texels.y() - centre_.y()) * scale_, texels.width() * scale_,
          texels.height() * scale_};
}

QRect TexelZoom::visibleTexels() const {
  const auto first = [](double centre, double half) { return int(std::floor(centre - half)); };
  const double halfWidth = widget_.width() / 2.0 / scale_;
  const double halfHeight = widget_.height() / 2.0 / scale_;
  const QPoint topLeft(first(centre_.x(), halfWidth), first(centre_.y(), halfHeight));
  const QPoint bottomRight(first(centre_.x(), -halfWidth), first(centre_.y(), -halfHeight));
  return QRect(topLeft, bottomRight) & QRect(QPoint(0, 0), map_);
}

}  // namespace umbra
