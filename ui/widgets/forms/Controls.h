// The input widgets that the forms are made of.
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>

#include "ui/widgets/forms/SliderScale.h"

namespace umbra {

// The wheel scrolls the panel and changes nothing unless the widget has the focus.
void ignoreWheelWithoutFocus(QWidget* widget);

// Jumps to where it is pressed.
class Slider : public QSlider {
 public:
  explicit Slider(QWidget* parent = nullptr);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
};

// A real number in the shortest form that stands for it ("1e-06"), stepped along a SliderScale.
class RealBox : public QDoubleSpinBox {
 public:
  explicit RealBox(QWidget* parent = nullptr);
  void setScale(const SliderScale& scale);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  void stepBy(int steps) override;

 private:
  QString bare(const QString& text) const;  // without suffix and blanks

  SliderScale scale_;
};

// A slider and a box for one number; a unit in the plural, such as "texels", loses its s beside 1.
// Lay the two out where they belong.
class NumberControl : public QObject {
  Q_OBJECT

 public:
  // The box takes numbers up to `most`, where that is more than the slider's scale has.
  NumberControl(const SliderScale& scale, const QString& unit, QWidget* parent, double most = 0.0);

  Slider* slider() { return slider_; }
  RealBox* box() { return box_; }
  double value() const { return value_; }
  // Emits nothing. A value outside the box's range widens it; one outside the scale stands at the
  // slider's end.
  void setValue(double value);

 signals:
  void changed(double value);
  void finished();  // the slider was let go or the box was left

 private:
  void take(double value);

  SliderScale scale_;
  double most_;
  QString unit_;
  Slider* slider_;
  RealBox* box_;
  double value_ = 0.0;
};

}  // namespace umbra
