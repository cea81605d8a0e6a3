#include "ui/widgets/forms/SettingEditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>

#include "filters/core/settings/SettingRow.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/Controls.h"

namespace umbra {
namespace {

QString toolTipOf(const Setting& setting) {
  const SettingInfo& info = setting.info;
  QString text = "<b>" + style::text(info.name).toHtmlEscaped() + "</b>";
  if (!info.symbol.empty()) text += "&nbsp; " + style::text(info.symbol).toHtmlEscaped();
  text += "<br>" + style::text(info.doc).toHtmlEscaped();
  if (info.kind == SettingKind::Camera) return text;
  text += "<br>";
  const bool choices = info.kind == SettingKind::Choice;
  if (const std::string range = rangeText(info); !range.empty() && !choices)
    text += style::text(range).toHtmlEscaped() + ", ";
  return text + QObject::tr("default %1")
                    .arg(style::text(defaultText(info, setting.defaultValue)).toHtmlEscaped());
}

SliderScale scaleOf(const SettingInfo& info) {
  const double low = info.automatic.empty() ? info.low : 0.0;
  return {low, info.reach > 0.0 ? info.reach : info.high, info.scale == Scale::Logarithmic,
          info.kind == SettingKind::Whole};
}

class NumberEditor : public SettingEditor {
 public:
  NumberEditor(const Setting& shown, QWidget* parent)
      : SettingEditor(shown, parent),
        whole_(info().kind == SettingKind::Whole),
        control_(new NumberControl(scaleOf(info()), style::text(info().unit), this, info().high)) {
    addTitled(control_->box());
    addBeneath(control_->slider());
    connect(control_, &NumberControl::changed, this, [this](double value) {
      take(whole_ ? SettingValue(int(value)) : SettingValue(value));
    });
    connect(control_, &NumberControl::finished, this, &SettingEditor::finished);
  }

 protected:
  void showValue(const SettingValue& value) override {
    control_->setValue(whole_ ? std::get<int>(value) : std::get<double>(value));
  }

 private:
  bool whole_;
  NumberControl* control_;
};

// Edits a number of which 0 is automatic, in a box without a slider.
class AutomaticEditor : public SettingEditor {
 public:
  AutomaticEditor(const Setting& shown, QWidget* parent)
      : SettingEditor(shown, parent), box_(new RealBox(this)) {
    box_->setScale(scaleOf(info()));  // what the arrow keys step over
    box_->setMaximum(info().high);
    box_->setSpecialValueText(tr("auto"));
    box_->setFixedWidth(box_->fontMetrics().horizontalAdvance("0000 texels") + 10);
    addTitled(box_);
    connect(box_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this](double value) { take(value > 0.0 ? std::max(value, info().low) : 0.0); });
    connect(box_, &QDoubleSpinBox::editingFinished, this, &SettingEditor::finished);
  }

  void setAutomaticText(const QString& text) override {
    const QSignalBlocker quiet(box_);
    box_->setSpecialValueText(text);
  }

 protected:
  void showValue(const SettingValue& value) override {
    const QSignalBlocker quiet(box_);
    const double number = std::get<double>(value);
    if (box_->value() != number) box_->setValue(number);
  }

 private:
  RealBox* box_;
};

// Edits choices, and whole numbers of which a form offers some. An item's data is its place among
// the choices, or the number.
class ChoiceEditor : public SettingEditor {
 public:
  ChoiceEditor(const Setting& shown, QWidget* parent)
      : SettingEditor(shown, parent), box_(new QComboBox(this)) {
    const auto& choices = info().choices;
    const std::size_t offered = info().offeredChoices ? info().offeredChoices : choices.size();
    for (std::size_t i = 0; i < offered; ++i) box_->addItem(textOf(int(i)), int(i));
    for (const int number : info().offered) box_->addItem(textOf(number), number);
    ignoreWheelWithoutFocus(box_);
    addTitled(box_);
    connect(box_, QOverload<int>::of(&QComboBox::activated), this, [this] {
      take(valueOf(box_->currentData().toInt()));
      emit finished();
    });
  }

  void refuseChoices(const std::function<QString(const SettingValue&)>& why) override {
    auto* items = qobject_cast<QStandardItemModel*>(box_->model());
    for (int row = 0; row < items->rowCount(); ++row) {
      QStandardItem* item = items->item(row);
      const QString reason = why(valueOf(item->data(Qt::UserRole).toInt()));
      item->setEnabled(reason.isEmpty());
      item->setToolTip(reason);
    }
  }

 protected:
  // A value that is not offered is added.
  void showValue(const SettingValue& value) override {
    int number = 0;
    if (const auto* name = std::get_if<std::string>(&value))
      number = int(std::find(info().choices.begin(), info().choices.end(), *name) -
                   info().choices.begin());
    else
      number = std::get<int>(value);
    if (box_->findData(number) < 0) box_->addItem(textOf(number), number);
    box_->setCurrentIndex(box_->findData(number));
  }

 private:
  SettingValue valueOf(int number) const {
    if (info().choices.empty()) return number;
    return std::string(info().choices[std::size_t(number)]);
  }

  QString textOf(int number) const {
    if (info().choices.empty())
      return style::text(info().offeredAs).replace('#', QString::number(number));
    const auto& texts = info().choiceTitles.empty() ? info().choices : info().choiceTitles;
    return style::text(texts[std::size_t(number)]);
  }

  QComboBox* box_;
};

// Edits the three coordinates of a point or direction, or the parts of a colour.
class PointEditor : public SettingEditor {
 public:
  PointEditor(const Setting& shown, QWidget* parent) : SettingEditor(shown, parent) {
    const double reach = info().reach > 0.0 ? info().reach : info().high;
    auto* boxes = new QWidget(this);
    auto* row = new QHBoxLayout(boxes);
    row->setContentsMargins(0, 0, 0, 0);
    for (RealBox*& box : boxes_) {
      box = new RealBox(boxes);
      box->setScale({std::max(info().low, -reach), reach});  // what the arrow keys step over
      box->setRange(info().low, info().high);
      box->setFixedWidth(box->fontMetrics().horizontalAdvance("-000.000") + 10);
      row->addWidget(box);
      connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
        take(std::vector{boxes_[0]->value(), boxes_[1]->value(), boxes_[2]->value()});
      });
      connect(box, &QDoubleSpinBox::editingFinished, this, &SettingEditor::finished);
    }
    addTitled(boxes);
  }

 protected:
  void showValue(const SettingValue& value) override {
    const auto& numbers = std::get<std::vector<double>>(value);
    for (std::size_t i = 0; i < std::size(boxes_); ++i) {
      const QSignalBlocker quiet(boxes_[i]);
      if (boxes_[i]->value() != numbers[i]) boxes_[i]->setValue(numbers[i]);
    }
  }

 private:
  RealBox* boxes_[3] = {};
};

// Edits a switch, or whether a camera is stored.
class TickEditor : public SettingEditor {
 public:
  TickEditor(const Setting& shown, QWidget* parent)
      : SettingEditor(shown, parent), box_(new QCheckBox(style::text(info().title), this)) {
    addBeneath(box_);
    connect(box_, &QCheckBox::clicked, this, [this](bool on) {
      if (info().kind == SettingKind::Switch)
        take(on);
      else
        take(on ? detail::numbersOf(camera()) : std::vector<double>());
      emit finished();
    });
  }

 protected:
  void showValue(const SettingValue& value) override {
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    box_->setChecked(numbers ? !numbers->empty() : std::get<bool>(value));
  }

 private:
  QCheckBox* box_;
};

}  // namespace

SettingEditor* SettingEditor::make(const Setting& setting, QWidget* parent) {
  const SettingInfo& info = setting.info;
  if (info.kind == SettingKind::Choice || !info.offered.empty())
    return new ChoiceEditor(setting, parent);
  if (info.kind == SettingKind::Switch || info.kind == SettingKind::Camera)
    return new TickEditor(setting, parent);
  if (info.kind == SettingKind::Point) return new PointEditor(setting, parent);
  if (!info.automatic.empty()) return new AutomaticEditor(setting, parent);
  return new NumberEditor(setting, parent);
}

SettingEditor::SettingEditor(const Setting& setting, QWidget* parent)
    : QWidget(parent), setting_(setting), lines_(new QVBoxLayout(this)) {
  lines_->setContentsMargins(0, 0, 0, 0);
  setToolTip(toolTipOf(setting));
  setObjectName(style::text(setting.info.name));
}

void SettingEditor::follow() {
  showValue(setting_.get());
  const bool idle = !setting_.whyIdle().empty();
  const bool greys = setting_.info.greyedWhenIdle;
  setEnabled(!idle || !greys);
  setVisible(!idle || greys);
}

void SettingEditor::take(const SettingValue& value) {
  setting_.put(value);
  emit changed();
}

void SettingEditor::addTitled(QWidget* editor) {
  auto* line = new QHBoxLayout;
  auto* title = new QLabel(style::text(setting_.info.title), this);
  title->setMinimumWidth(0);
  line->addWidget(title, 1);
  line->addWidget(editor);
  lines_->addLayout(line);
}

void SettingEditor::addBeneath(QWidget* editor) {
  lines_->addWidget(editor);
}

}  // namespace umbra
