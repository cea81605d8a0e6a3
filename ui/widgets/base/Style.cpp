#include "ui/widgets/base/Style.h"

#include <QFontMetricsF>
#include <QTextDocument>
#include <cmath>

namespace umbra::style {
namespace {

bool digitsAlign(const QFont& font) {
  const QFontMetricsF metrics(font);
  const double width = metrics.horizontalAdvance('0');
  for (char digit = '1'; digit <= '9'; ++digit)
    if (std::abs(metrics.horizontalAdvance(digit) - width) > 0.05) return false;
  return true;
}

QString withTrueMinus(QString number) {
  return number.replace('-', QChar(0x2212));
}

}  // namespace

QFont figures(const QFont& base) {
  if (digitsAlign(base)) return base;
  QFont other = base;
  other.setFamilies({"DejaVu Sans Condensed", "DejaVu Sans", "Liberation Sans"});
  return other;
}

QColor tint(const QColor& colour) {
  const auto mixed = [](int channel) { return 255 - (255 - channel) / 10; };
  return {mixed(colour.red()), mixed(colour.green()), mixed(colour.blue())};
}

QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), int(utf8.size()));
}

QString plainTip(const QString& text) {
  return Qt::mightBeRichText(text) ? "<qt>" + text.toHtmlEscaped() + "</qt>" : text;
}

QString label(std::string_view kebabCase) {
  QString words = text(kebabCase).replace('-', ' ');
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

QString signedFigure(double value) {
  // A value that rounds to zero is written as +0.000: a minus there would say more than the digits
  // do.
  const QString digits = QString::number(std::abs(value), 'f', 3);
  const bool negative = value < 0.0 && digits != "0.000";
  return (negative ? QString(QChar(0x2212)) : QString("+")) + digits;
}

QString figure(double value) {
  return withTrueMinus(QString::number(value, 'g', 4));
}

QString sheet() {
  return QString(R"(
    QSlider { min-height: 18px; }
    QSlider::groove:horizontal { height: 3px; border-radius: 1px; background: %2; }
    QSlider::sub-page:horizontal:enabled { border-radius: 1px; background: #b9cbe6; }
    QSlider::handle:horizontal { width: 12px; height: 12px; margin: -5px 0; border-radius: 6px;
                                 background: %1; }
    QSlider::handle:horizontal:disabled { background: #c3cad2; }
    QSlider::handle:horizontal:focus { border: 1px solid %3; width: 10px; height: 10px; }
    QDoubleSpinBox, QLineEdit { border: 1px solid transparent; border-radius: 3px; padding: 1px 1px 1px 3px;
                                background: transparent; }
    QDoubleSpinBox:hover, QDoubleSpinBox:focus, QLineEdit { border-color: %2; background: white; }
    QLineEdit:disabled { background: transparent; color: #9aa5b1; }
    QLineEdit:focus { border-color: %1; }
    QToolButton { border: none; border-radius: 3px; padding: 2px 4px; color: %4; }
    QToolButton:hover { background: %5; color: %3; }
    QToolButton:disabled { color: #c3cad2; }
    QTableView { border: none; background: transparent; }
    QListView { border: none; background: transparent; }
  )")
      .arg(accent.name(), border.name(), ink.name(), muted.name(), ground.name());
}

}  // namespace umbra::style
