#include "ui/widgets/forms/ParameterRow.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <optional>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/Controls.h"

namespace umbra {
namespace {

QString toolTipOf(const Parameter& parameter) {
  const QString symbol = style::text(parameter.symbol), unit = style::text(parameter.unit);
  QString facts = "<b>" + style::text(parameter.name).toHtmlEscaped() + "</b>";
  if (!symbol.isEmpty()) facts += "&nbsp; " + symbol.toHtmlEscaped();
  if (!unit.isEmpty()) facts += QObject::tr(", in %1").arg(unit.toHtmlEscaped());
  facts += "<br>" + style::text(parameter.doc).toHtmlEscaped() + "<br>";
  if (parameter.choices.empty())
    facts +=
        QObject::tr("%1 … %2, ").arg(style::figure(parameter.low), style::figure(parameter.high));
  return facts + QObject::tr("default %1").arg(style::text(toText(parameter.defaultValue)));
}

SliderScale scaleOf(const Parameter& parameter) {
  return {parameter.low, parameter.high, parameter.scale == Scale::Logarithmic,
          std::holds_alternative<int>(parameter.defaultValue)};
}

// The row of a real number or an integer.
class NumberRow : public ParameterRow {
 public:
  NumberRow(const Parameter& shown, QWidget* parent)
      : ParameterRow(shown, parent),
        whole_(std::holds_alternative<int>(shown.defaultValue)),
        control_(new NumberControl(scaleOf(shown), style::text(shown.unit), this)) {
    addBeside(control_->box());
    addBeneath(control_->slider());
    connect(control_, &NumberControl::changed, this, [this](double value) {
      take(whole_ ? ParameterValue(int(value)) : ParameterValue(value));
    });
    connect(control_, &NumberControl::finished, this, &ParameterRow::finished);
  }

 protected:
  void showValue(const ParameterValue& value) override {
    control_->setValue(whole_ ? std::get<int>(value) : std::get<double>(value));
  }

 private:
  bool whole_;
  NumberControl* control_;
};

class ChoiceRow : public ParameterRow {
 public:
  ChoiceRow(const Parameter& shown, QWidget* parent)
      : ParameterRow(shown, parent), box_(new QComboBox(this)) {
    for (std::string_view choice : shown.choices)
      box_->addItem(style::label(choice), style::text(choice));
    ignoreWheelWithoutFocus(box_);
    addBeside(box_);
    connect(box_, QOverload<int>::of(&QComboBox::activated), this, [this] {
      take(box_->currentData().toString().toStdString());
      emit finished();
    });
  }

 protected:
  void showValue(const ParameterValue& value) override {
    box_->setCurrentIndex(box_->findData(QString::fromStdString(std::get<std::string>(value))));
  }

 private:
  QComboBox* box_;
};

// The row of a list of numbers, separated by ':' as on the command line. A wrong text is explained
// and changes nothing.
class ListRow : public ParameterRow {
 public:
  ListRow(const Parameter& shown, QWidget* parent)
      : ParameterRow(shown, parent), text_(new QLineEdit(this)), problem_(new QLabel(this)) {
    text_->setPlaceholderText(tr("0.2:0.5:0.7"));
    text_->setFont(style::figures(font()));
    problem_->setObjectName("problem");
    problem_->setWordWrap(true);
    problem_->setStyleSheet("color: " + style::error.name());
    problem_->hide();
    addBeneath(text_);
    addBeneath(problem_);
    connect(text_, &QLineEdit::textEdited, this, [this] { check(); });
    connect(text_, &QLineEdit::editingFinished, this, [this] {
      if (!text_->isModified()) return;
      const std::optional<ParameterValue> value = check();
      if (!value) return;
      text_->setModified(false);
      take(*value);
      emit finished();
    });
  }

 protected:
  void showValue(const ParameterValue& value) override {
    if (text_->hasFocus() && text_->isModified()) return;  // it is being typed
    text_->setText(QString::fromStdString(toText(value)));
    problem_->hide();
  }

 private:
  // The value of the present text; the technique that the row is bound to does not change.
  std::optional<ParameterValue> check() {
    const ParameterValue before = parameter().get();
    try {
      parameter().setFromText(text_->text().trimmed().toStdString(), parameter().name);
      const ParameterValue typed = parameter().get();
      parameter().put(before);
      problem_->hide();
      return typed;
    } catch (const Error& error) {
      problem_->setText(QString::fromStdString(error.what()));
      problem_->show();
      return std::nullopt;
    }
  }

  QLineEdit* text_;
  QLabel* problem_;
};

}  // namespace

ParameterRow* ParameterRow::make(const Parameter& parameter, QWidget* parent) {
  ParameterRow* row = nullptr;
  if (std::holds_alternative<std::string>(parameter.defaultValue))
    row = new ChoiceRow(parameter, parent);
  else if (std::holds_alternative<std::vector<double>>(parameter.defaultValue))
    row = new ListRow(parameter, parent);
  else
    row = new NumberRow(parameter, parent);
  row->follow(parameter);
  return row;
}

ParameterRow::ParameterRow(const Parameter& parameter, QWidget* parent)
    : QWidget(parent),
      parameter_(parameter),
      reset_(new QToolButton(this)),
      line_(new QHBoxLayout),
      rows_(new QVBoxLayout(this)) {
  const QString symbol = style::text(parameter.symbol).toHtmlEscaped();
  auto* label = new QLabel(
      QString("%1 <span style='color:%2'>%3</span>")
          .arg(style::label(parameter.name).toHtmlEscaped(), style::muted.name(), symbol),
      this);
  label->setWordWrap(true);
  label->setMinimumWidth(0);
  reset_->setText(QString(QChar(0x21ba)));
  reset_->setAutoRaise(true);
  reset_->setStyleSheet("padding: 0px");
  reset_->setFixedWidth(18);
  reset_->setToolTip(
      tr("Back to the default, %1").arg(style::text(toText(parameter.defaultValue))));
  QSizePolicy policy = reset_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  reset_->setSizePolicy(policy);
  setToolTip(toolTipOf(parameter));
  setObjectName(style::text(parameter.name));

  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(0);
  line_->setSpacing(2);
  line_->addWidget(label, 1);
  line_->addWidget(reset_);
  rows_->addLayout(line_);
  connect(reset_, &QToolButton::clicked, this, [this] {
    take(parameter_.defaultValue);
    showValue(parameter_.defaultValue);
    emit finished();
  });
}

void ParameterRow::follow(const Parameter& parameter) {
  parameter_ = parameter;
  showValue(parameter_.get());
  showReset();
}

QString ParameterRow::name() const {
  return style::text(parameter_.name);
}

void ParameterRow::take(const ParameterValue& value) {
  parameter_.put(value);
  showReset();
  emit changed(value);
}

void ParameterRow::addBeside(QWidget* editor) {
  line_->addWidget(editor);
}
void ParameterRow::addBeneath(QWidget* editor) {
  rows_->addWidget(editor);
}

void ParameterRow::showReset() {
  reset_->setVisible(parameter_.get() != parameter_.defaultValue);
}

}  // namespace umbra
