#include "ui/widgets/maps/ShadowMapCanvas.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleHints>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr double gridFrom = 6.0;  // from this scale on texels have lines between them

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

ShadowMapCanvas::ShadowMapCanvas(QWidget* parent) : QWidget(parent), zoom_(*this) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ShadowMapCanvas::redraw() {
  visibleStale_ = true;
  update();
}

void ShadowMapCanvas::setValues(Image<float> values) {
  const Image<float>& before = colours_.values();
  const bool sameSize = values.width() == before.width() && values.height() == before.height();
  zoom_.setMap({values.width(), values.height()});
  colours_.setValues(std::move(values));
  if (!sameSize) zoom_.fit();
  redraw();
}

void ShadowMapCanvas::setColourMap(ColourMap map) {
  colours_.setColourMap(map);
  redraw();
}

void ShadowMapCanvas::setRegion(const std::optional<Region>& region) {
  region_ = region;
  update();
}

void ShadowMapCanvas::fit() {
  zoom_.fit();
  redraw();
}

void ShadowMapCanvas::showRegion() {
  const QRect texels = regionTexels();
  if (texels.isEmpty()) return fit();
  zoom_.show(texels);
  redraw();
}

void ShadowMapCanvas::zoomAbout(const QPointF& point, double factor) {
  if (empty()) return;
  zoom_.zoomAbout(point, factor);
  redraw();
}

QRect ShadowMapCanvas::regionTexels() const {
  if (!region_ || region_->texels.empty()) return {};
  QRect bounds(region_->texels.front().x, region_->texels.front().y, 1, 1);
  for (const RegionTexel& texel : region_->texels) bounds |= QRect(texel.x, texel.y, 1, 1);
  return bounds;
}

void ShadowMapCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (empty()) {
    painter.fillRect(rect(), style::ground);
    painter.setPen(style::muted);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No shadow map yet"));
    return;
  }
  if (visibleStale_ || visible_.devicePixelRatio() != devicePixelRatioF())
    visible_ = colours_.draw(zoom_, size(), devicePixelRatioF());
  visibleStale_ = false;
  painter.drawImage(0, 0, visible_);
  if (scale() >= gridFrom) drawGrid(painter);
  if (showsFigures()) drawValues(painter);
  drawRegion(painter);
}

void ShadowMapCanvas::drawGrid(QPainter& painter) const {
  const QRect texels = zoom_.visibleTexels();
  const QRectF area = rectOfTexels(texels);
  painter.setPen(QPen(QColor(255, 255, 255, scale() < 2 * gridFrom ? 60 : 120), 1.0));
  for (int i = 0; i <= texels.width(); ++i) {
    const double x = area.left() + i * scale();
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  }
  for (int i = 0; i <= texels.height(); ++i) {
    const double y = area.top() + i * scale();
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
  }
}

QFont ShadowMapCanvas::figureFont() const {
  QFont small = style::figures(font());
  small.setPixelSize(std::max(9, QFontInfo(font()).pixelSize() - 2));
  return small;
}

bool ShadowMapCanvas::showsFigures() const {
  return QFontMetricsF(figureFont()).horizontalAdvance("0.0000") + 6 <= scale();
}

void ShadowMapCanvas::drawValues(QPainter& painter) const {
  painter.setFont(figureFont());
  const QRect texels = zoom_.visibleTexels();
  for (int y = texels.top(); y <= texels.bottom(); ++y)
    for (int x = texels.left(); x <= texels.right(); ++x) {
      const bool light = qGray(colours_.colourAt(x, y)) > 140;
      painter.setPen(light ? style::ink : QColor(Qt::white));
      painter.drawText(rectOfTexels({x, y, 1, 1}), Qt::AlignCenter, style::figure(valueAt({x, y})));
    }
}

void ShadowMapCanvas::drawRegion(QPainter& painter) const {
  const QRect texels = regionTexels();
  if (texels.isEmpty()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QRectF outline = rectOfTexels(texels);
  // A dark line beneath keeps the amber visible on yellow depths.
  for (const QPen& pen : {QPen(QColor(31, 41, 51, 140), 4.0), QPen(style::probe, 2.0)}) {
    painter.setPen(pen);
    painter.drawRect(outline);
    // An outline that is too small to be found has a ring around it.
    if (std::max(outline.width(), outline.height()) < 14.0)
      painter.drawEllipse(outline.center(), 14.0, 14.0);
  }
  const QRectF texel = rectOfTexels({region_->x, region_->y, 1, 1});
  if (texel.width() < 3.0) return;
  const double radius = std::clamp(texel.width() / 4.0, 2.0, 6.0);
  // Where a figure stands in the middle of the texel, the mark goes into a corner.
  const QPointF mark =
      showsFigures() ? texel.topLeft() + QPointF(radius + 4, radius + 4) : texel.center();
  painter.setPen(QPen(Qt::white, 1.0));
  painter.setBrush(style::probe);
  painter.drawEllipse(mark, radius, radius);
}

void ShadowMapCanvas::resizeEvent(QResizeEvent*) {
  zoom_.follow();
  redraw();
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
      zoom_.pan(moved);
      redraw();
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
