// A pointer that moves: QTest's own moves the cursor, which has no effect on a button held down.
#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>

namespace umbra {

inline void moveMouse(QWidget* widget, const QPoint& to, Qt::MouseButtons held = Qt::NoButton) {
  QMouseEvent event(QEvent::MouseMove, to, widget->mapToGlobal(to), Qt::NoButton, held,
                    Qt::NoModifier);
  QApplication::sendEvent(widget, &event);
}

}  // namespace umbra
