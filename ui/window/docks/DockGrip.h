// The strip by which a dock is moved; the card beneath it has the title.
#pragma once

#include <QWidget>

namespace umbra {

class DockGrip : public QWidget {
  Q_OBJECT

 public:
  explicit DockGrip(QWidget* parent = nullptr);

  QSize sizeHint() const override { return {40, 9}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace umbra
