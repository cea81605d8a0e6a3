// The line between the two techniques of a wipe, to be dragged.
#pragma once

#include <QWidget>

namespace umbra {

// The handle lies over the picture: its parent is the widget that shows it.
class WipeHandle : public QWidget {
  Q_OBJECT

 public:
  explicit WipeHandle(QWidget* picture);

  void setPosition(double position);  // of the picture's width, 0 … 1
  double position() const { return position_; }

 signals:
  void moved(double position);  // while it is dragged
  void released();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;  // the picture's size
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void place();

  double position_ = 0.5;
  double grip_ = 0.0;  // logical pixels from the line to where it was taken
};

}  // namespace umbra
