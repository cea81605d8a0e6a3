#include "ui/widgets/forms/Controls.h"

#include <QEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionSlider>
#include <cmath>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

class WheelGuard : public QObject {
 public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::Wheel || !widget || widget->hasFocus()) return false;
    event->ignore();
    return true;
  }
};

QString suffixOf(const QString& unit, double value) {
  if (unit.isEmpty()) return {};
  return " " + (value == 1.0 && unit.endsWith('s') ? unit.chopped(1) : unit);
}

}  // namespace

void ignoreWheelWithoutFocus(QWidget* widget) {
  widget->setFocusPolicy(Qt::StrongFocus);
  widget->installEventFilter(new WheelGuard(widget));
}

Slider::Slider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  ignoreWheelWithoutFocus(this);
  setMinimumWidth(60);
}

void Slider::mousePressEvent(QMouseEvent* event) {
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect handle =
      style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
  if (event->button() == Qt::LeftButton && !handle.contains(event->pos())) {
    // The press has to find the handle under it, so that the drag goes on from there.
    const int span = width() - handle.width();
    setValue(QStyle::sliderValueFromPosition(minimum(), maximum(),
                                             event->pos().x() - handle.width() / 2, span));
  }
  QSlider::mousePressEvent(event);
}

RealBox::RealBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  setAlignment(Qt::AlignRight);
  setKeyboardTracking(false);
  setLocale(QLocale::c());
  // Enough that Qt's rounding to decimals never touches a value of 1e-12.
  setDecimals(30);
  setFont(style::figures(font()));
  ignoreWheelWithoutFocus(this);
}

void RealBox::setScale(const SliderScale& scale) {
  scale_ = scale;
  setRange(scale.low, scale.high);
}

QString RealBox::textFromValue(double value) const {
  return QString::number(value, 'g', 5);
}

QString RealBox::bare(const QString& text) const {
  QString number = text;
  if (!suffix().isEmpty() && number.endsWith(suffix())) number.chop(suffix().size());
  return number.trimmed().replace(QChar(0x2212), '-').replace(',', '.');
}

double RealBox::valueFromText(const QString& text) const {
  // The text may be shorter than the value: leaving the box untouched must not round it.
  const QString number = bare(text);
  if (number == textFromValue(value())) return value();
  const double typed = QLocale::c().toDouble(number);
  return scale_.whole ? std::round(typed) : typed;
}

QValidator::State RealBox::validate(QString& text, int&) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return QValidator::Acceptable;
  bool isNumber = false;
  const double typed = QLocale::c().toDouble(bare(text), &isNumber);
  if (isNumber && typed >= minimum() && typed <= maximum()) return QValidator::Acceptable;
  for (QChar c : bare(text))
    if (!QString("0123456789.eE+-").contains(c)) return QValidator::Invalid;
  return QValidator::Intermediate;
}

void RealBox::stepBy(int steps) {
  setValue(scale_.stepped(value(), steps));
}

NumberControl::NumberControl(const SliderScale& scale, const QString& unit, QWidget* parent,
                             double most)
    : QObject(parent),
      scale_(scale),
      most_(std::max(most, scale.high)),
      unit_(unit),
      slider_(new Slider(parent)),
      box_(new RealBox(parent)) {
  slider_->setRange(0, scale.positions());
  slider_->setPageStep(std::max(1, scale.positions() / 20));
  box_->setScale(scale);
  box_->setSuffix(suffixOf(unit, 0.0));
  const QString widest = scale.whole ? "0000" : scale.logarithmic ? "0.00e-00" : "0.00000";
  box_->setFixedWidth(box_->fontMetrics().horizontalAdvance(widest + box_->suffix()) + 10);
  setValue(scale.low);

  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { take(scale_.valueAt(position)); });
  connect(box_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &NumberControl::take);
  connect(slider_, &QSlider::sliderReleased, this, &NumberControl::finished);
  connect(box_, &QDoubleSpinBox::editingFinished, this, &NumberControl::finished);
}

void NumberControl::setValue(double value) {
  value_ = value;
  const QSignalBlocker quietSlider(slider_), quietBox(box_);
  box_->setRange(std::min(scale_.low, value), std::max(most_, value));
  if (box_->value() != value) box_->setValue(value);
  box_->setSuffix(suffixOf(unit_, value));
  // While the slider is dragged, it stays under the pointer.
  if (!slider_->isSliderDown()) slider_->setValue(scale_.positionOf(value));
}

void NumberControl::take(double value) {
  if (value == value_) return;
  setValue(value);
  emit changed(value);
}

}  // namespace umbra
