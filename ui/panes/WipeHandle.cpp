#include "ui/panes/WipeHandle.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int thickness = 18;  // logical pixels: easily taken
constexpr double knobWidth = 14.0, knobHeight = 30.0;

}  // namespace

WipeHandle::WipeHandle(QWidget* picture) : QWidget(picture) {
  setObjectName("wipe");
  setCursor(Qt::SplitHCursor);
  setFocusPolicy(Qt::NoFocus);
  setToolTip(tr("Drag to see more of one side or of the other"));
  picture->installEventFilter(this);
  place();
}

void WipeHandle::setPosition(double position) {
  position_ = std::clamp(position, 0.0, 1.0);
  place();
}

void WipeHandle::place() {
  const QWidget& picture = *parentWidget();
  // At the picture's edge one half of the handle is still in sight, and can be taken.
  const int middle = int(std::lround(position_ * picture.width()));
  setGeometry(middle - thickness / 2, 0, thickness, picture.height());
  raise();
}

bool WipeHandle::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent() && event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

void WipeHandle::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF middle(width() / 2.0, height() / 2.0);
  const QLineF line(middle.x(), 0.0, middle.x(), height());
  painter.setPen(QPen(QColor(0x1f, 0x29, 0x33, 0x90), 4.0));
  painter.drawLine(line);
  painter.setPen(QPen(Qt::white, 2.0));
  painter.drawLine(line);
  const QRectF knob(middle.x() - knobWidth / 2.0, middle.y() - knobHeight / 2.0, knobWidth,
                    knobHeight);
  painter.setPen(QPen(QColor(0x1f, 0x29, 0x33, 0x90), 1.0));
  painter.setBrush(Qt::white);
  painter.drawRoundedRect(knob, 5.0, 5.0);
  painter.setPen(QPen(style::muted, 1.2));
  for (const double x : {-2.0, 2.0})
    painter.drawLine(QLineF(middle.x() + x, middle.y() - 6.0, middle.x() + x, middle.y() + 6.0));
}

void WipeHandle::mousePressEvent(QMouseEvent* event) {
  event->setAccepted(event->button() == Qt::LeftButton);
  grip_ = event->localPos().x() - width() / 2.0;
}

void WipeHandle::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton) || parentWidget()->width() <= 0) return;
  const double x = this->x() + event->localPos().x() - grip_;
  emit moved(std::clamp(x / parentWidget()->width(), 0.0, 1.0));
}

void WipeHandle::mouseReleaseEvent(QMouseEvent*) {
  emit released();
}

}  // namespace umbra
