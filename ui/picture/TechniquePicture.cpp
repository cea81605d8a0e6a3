#include "ui/picture/TechniquePicture.h"

#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "ui/widgets/base/Style.h"

namespace umbra {

TechniquePicture::TechniquePicture(QWidget* parent)
    : QWidget(parent), overlay_(new SceneOverlay(this)) {
  setMouseTracking(true);
  setCursor(Qt::PointingHandCursor);
}

void TechniquePicture::setPicture(const QImage& picture) {
  picture_ = picture;
  message_.clear();
  update();
}

void TechniquePicture::setContents(SceneOverlay::Contents contents) {
  // Their figures are of the session's technique, and its pane is where one is told what to do.
  contents.heading.clear();
  contents.verdict.clear();
  contents.hint.clear();
  contents.curtain = {};
  contents.curtainText.clear();
  contents.framed = false;
  overlay_->setVisible(message_.isEmpty());
  overlay_->setContents(std::move(contents));
}

void TechniquePicture::setMessage(const QString& message) {
  picture_ = {};
  message_ = message;
  overlay_->hide();
  update();
}

void TechniquePicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!picture_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), picture_);
    return;
  }
  painter.fillRect(rect(), style::ground);
  painter.setPen(style::muted);
  painter.drawText(rect().adjusted(12, 8, -12, -8), Qt::AlignCenter | Qt::TextWordWrap, message_);
}

void TechniquePicture::resizeEvent(QResizeEvent*) {
  overlay_->setGeometry(rect());
}

void TechniquePicture::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit chosen();
}

void TechniquePicture::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton) return;
  const double ratio = devicePixelRatioF();
  emit hovered({int(std::floor(event->localPos().x() * ratio)),
                int(std::floor(event->localPos().y() * ratio))});
}

}  // namespace umbra
