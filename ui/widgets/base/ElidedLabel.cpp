#include "ui/widgets/base/ElidedLabel.h"

#include <QPainter>

#include "ui/widgets/base/Style.h"

namespace umbra {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
}

QSize ElidedLabel::minimumSizeHint() const {
  return {fontMetrics().horizontalAdvance("MM…"), QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::WindowText));
  const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, width());
  painter.drawText(rect(), int(alignment() | Qt::AlignVCenter), shown);
  // Where the text is cut, the tool tip has all of it.
  setToolTip(shown == text() ? QString() : style::plainTip(text()));
}

}  // namespace umbra
