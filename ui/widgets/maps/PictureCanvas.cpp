#include "ui/widgets/maps/PictureCanvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr double largestZoom = 64.0;
constexpr double clickReach = 4.0;     // widget pixels that a click may wander
constexpr double pointDistance = 2.0;  // widget pixels between two points of a lasso
constexpr double markRadius = 6.0;
const QColor underline{0x1f, 0x29, 0x33, 0x90};  // keeps lines visible on light ground

double lengthOf(const QPointF& way) {
  return std::hypot(way.x(), way.y());
}

}  // namespace

PictureCanvas::PictureCanvas(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PictureCanvas::setPicture(const QImage& picture) {
  if (picture.size() != picture_.size()) {
    zoom_ = 1.0;
    centre_ = QPointF(picture.width() / 2.0, picture.height() / 2.0);
    pressed_.reset();  // what is being drawn is of the picture before
    drawn_.clear();
  }
  picture_ = picture;
  shrunk_ = {};
  update();
}

void PictureCanvas::setHint(const QString& hint) {
  hint_ = hint;
  update();
}

void PictureCanvas::setFaded(bool faded) {
  faded_ = faded;
  update();
}

void PictureCanvas::setNote(const QString& note) {
  note_ = note;
  update();
}

void PictureCanvas::setMark(const std::optional<QPointF>& mark) {
  if (mark == mark_) return;
  mark_ = mark;
  update();
}

void PictureCanvas::setLasso(const QPolygonF& lasso) {
  lasso_ = lasso;
  update();
}

double PictureCanvas::scale() const {
  if (picture_.isNull()) return 1.0;
  return zoom_ * std::min(double(width()) / picture_.width(), double(height()) / picture_.height());
}

QPointF PictureCanvas::toWidget(const QPointF& picture) const {
  return QPointF(width() / 2.0, height() / 2.0) + (picture - centre_) * scale();
}

QPointF PictureCanvas::toPicture(const QPointF& widget) const {
  return centre_ + (widget - QPointF(width() / 2.0, height() / 2.0)) / scale();
}

std::optional<QPoint> PictureCanvas::pixelAt(const QPointF& point) const {
  const QPointF at = toPicture(point);
  const QPoint pixel(int(std::floor(at.x())), int(std::floor(at.y())));
  if (!picture_.rect().contains(pixel)) return std::nullopt;
  return pixel;
}

void PictureCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), style::ground);
  if (picture_.isNull()) {
    painter.setPen(style::muted);
    painter.drawText(rect().adjusted(10, 6, -10, -6), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  drawPicture(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  if (drawing())
    drawOutline(painter, drawn_, false);
  else if (!lasso_.isEmpty())
    drawOutline(painter, lasso_, true);
  drawMark(painter);
  drawNote(painter);
}

void PictureCanvas::drawPicture(QPainter& painter) {
  const QRectF target(toWidget({0.0, 0.0}), QSizeF(picture_.size()) * scale());
  const double ratio = devicePixelRatioF();
  if (scale() * ratio < 1.0) {
    // The picture is averaged as it shrinks, so that no thin error is lost between two pixels of
    // the screen.
    const QSize size = (target.size() * ratio).toSize().expandedTo({1, 1});
    if (shrunk_.size() != size)
      shrunk_ = picture_.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    painter.drawImage(target, shrunk_);
  } else {
    painter.drawImage(target, picture_);
  }
  if (faded_) painter.fillRect(target, QColor(0xf3, 0xf4, 0xf6, 0xb0));
}

void PictureCanvas::drawOutline(QPainter& painter, const QPolygonF& lasso, bool closed) const {
  QPolygonF shown;
  for (const QPointF& point : lasso) shown << toWidget(point);
  QPainterPath path;
  path.addPolygon(shown);
  if (closed) path.closeSubpath();
  painter.strokePath(path, QPen(underline, 3.5));
  painter.strokePath(path, QPen(style::accent.lighter(140), 1.6));
}

void PictureCanvas::drawMark(QPainter& painter) const {
  if (!mark_) return;
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(underline, 4.0), QPen(style::probe, 2.0)}) {
    painter.setPen(pen);
    painter.drawEllipse(toWidget(*mark_), markRadius, markRadius);
  }
}

void PictureCanvas::drawNote(QPainter& painter) const {
  if (note_.isEmpty()) return;
  const QFontMetricsF metrics(font());
  const QString text = metrics.elidedText(note_, Qt::ElideRight, width() - 28.0);
  const QSizeF size(metrics.horizontalAdvance(text) + 20.0, metrics.height() + 8.0);
  const QRectF frame(QPointF((width() - size.width()) / 2.0, 6.0), size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0x1f, 0x29, 0x33, 0xe0));
  painter.drawRoundedRect(frame, size.height() / 2.0, size.height() / 2.0);
  painter.setPen(Qt::white);
  painter.drawText(frame, Qt::AlignCenter, text);
}

void PictureCanvas::wheelEvent(QWheelEvent* event) {
  if (picture_.isNull()) return;
  const QPointF point = event->position(), under = toPicture(point);
  zoom_ = std::clamp(zoom_ * std::exp2(event->angleDelta().y() / 240.0), 1.0, largestZoom);
  centre_ = under - (point - QPointF(width() / 2.0, height() / 2.0)) / scale();
  if (zoom_ == 1.0) centre_ = QPointF(picture_.width() / 2.0, picture_.height() / 2.0);
  shrunk_ = {};
  update();
}

void PictureCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || picture_.isNull()) return;
  pressed_ = event->localPos();
  drawn_.clear();
}

void PictureCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF point = event->localPos();
  if (const auto pixel = pixelAt(point))
    emit pixelHovered(pixel->x(), pixel->y());
  else
    emit left();
  if (!pressed_ || !(event->buttons() & Qt::LeftButton)) return;
  if (drawn_.isEmpty()) {
    if (lengthOf(point - *pressed_) <= clickReach) return;
    drawn_ << toPicture(*pressed_);
  } else if (lengthOf(point - toWidget(drawn_.back())) < pointDistance) {
    return;
  }
  drawn_ << toPicture(point);
  update();
}

void PictureCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressed_) return;
  pressed_.reset();
  const QPolygonF lasso = drawn_;
  drawn_.clear();
  update();
  if (lasso.size() > 2) {
    emit lassoDrawn(lasso);
  } else if (const auto pixel = pixelAt(event->localPos())) {
    emit pixelClicked(pixel->x(), pixel->y());
  }
}

void PictureCanvas::leaveEvent(QEvent*) {
  emit left();
}

// Escape ends a drag; without one it is left to others.
bool PictureCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && pressed_)
    event->accept();
  return QWidget::event(event);
}

void PictureCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !pressed_) return QWidget::keyPressEvent(event);
  pressed_.reset();
  drawn_.clear();
  update();
}

}  // namespace umbra
