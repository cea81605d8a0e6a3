#include "ui/window/docks/DockGrip.h"

#include <QPainter>

#include "ui/widgets/base/Style.h"

namespace umbra {

DockGrip::DockGrip(QWidget* parent) : QWidget(parent) {
  setToolTip(tr("Drag to move this pane, double-click to float it"));
  setCursor(Qt::SizeAllCursor);
  setAttribute(Qt::WA_Hover);
}

void DockGrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(underMouse() ? style::muted : QColor(0xc3, 0xca, 0xd2));
  for (int i = -2; i <= 2; ++i)
    painter.drawEllipse(QPointF(width() / 2.0 + 6.0 * i, height() / 2.0), 1.3, 1.3);
}

}  // namespace umbra
