#include "ui/widgets/forms/NumberField.h"

#include <charconv>

#include "filters/core/support/Parameters.h"
#include "ui/widgets/base/Style.h"

namespace umbra {

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
  setFont(style::figures(font()));
  setMinimumWidth(64);
  connect(this, &QLineEdit::textChanged, this, &NumberField::showWhetherRight);
  connect(this, &QLineEdit::editingFinished, this, [this] {
    if (text() == known_) return;
    known_ = text();
    emit numberEdited();
  });
}

void NumberField::setNumber(const std::optional<double>& number) {
  known_ = number ? QString::fromStdString(toText(ParameterValue(*number))) : QString();
  if (text() == known_) return;
  setText(known_);
  setCursorPosition(0);
}

std::optional<double> NumberField::number() const {
  const std::string typed =
      text().trimmed().replace(QChar(0x2212), '-').replace(',', '.').toStdString();
  double value = 0.0;
  const auto [end, problem] = std::from_chars(typed.data(), typed.data() + typed.size(), value);
  if (typed.empty() || problem != std::errc() || end != typed.data() + typed.size())
    return std::nullopt;
  return value;
}

bool NumberField::isRight() const {
  return number() || text().trimmed().isEmpty();
}

void NumberField::showWhetherRight() {
  QPalette shown;
  if (!isRight()) shown.setColor(QPalette::Text, style::error);
  setPalette(shown);
}

}  // namespace umbra
