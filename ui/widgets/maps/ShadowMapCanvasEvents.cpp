// The mouse on the shadow map: wheel zooms, drag pans, click names a texel, double click fits.
#include <QGuiApplication>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>
#include <cmath>

#include "ui/widgets/maps/ShadowMapCanvas.h"

namespace umbra {
namespace {

// The middle of the pixel that a mouse event names.
QPointF placeOf(const QMouseEvent* event, double ratio) {
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  const QPointF corner = event->position();
#else
  const QPointF corner = event->localPos();
#endif
  return corner + QPointF(0.5, 0.5) / ratio;
}

}  // namespace

void ShadowMapCanvas::resizeEvent(QResizeEvent*) {
  if (fitted_)
    fit();
  else
    setView(scale_, centre_);
}

void ShadowMapCanvas::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  zoomAbout(event->position(), std::pow(1.25, notches));
  event->accept();
}

void ShadowMapCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  dragFrom_ = placeOf(event, devicePixelRatioF());
  dragged_ = false;
}

void ShadowMapCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF place = placeOf(event, devicePixelRatioF());
  if (dragFrom_) {
    const QPointF moved = place - *dragFrom_;
    if (dragged_ || moved.manhattanLength() >= QGuiApplication::styleHints()->startDragDistance()) {
      dragged_ = true;
      fitted_ = false;
      setView(scale_, centre_ - moved / scale_);
      dragFrom_ = place;
    }
    return;
  }
  if (const auto texel = texelAt(place))
    emit texelHovered(texel->x(), texel->y());
  else
    emit left();
}

void ShadowMapCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !dragFrom_) return;
  dragFrom_.reset();
  if (dragged_) return;
  if (const auto texel = texelAt(placeOf(event, devicePixelRatioF())))
    emit texelClicked(texel->x(), texel->y());
}

void ShadowMapCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) fit();
}

void ShadowMapCanvas::leaveEvent(QEvent*) {
  emit left();
}

}  // namespace umbra
