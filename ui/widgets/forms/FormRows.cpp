#include "ui/widgets/forms/FormRows.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "ui/widgets/forms/Controls.h"

namespace umbra {

QWidget* row(QVBoxLayout* body, const QString& text, QWidget* editor, const QString& toolTip) {
  auto* holder = new QWidget;
  auto* line = new QHBoxLayout(holder);
  line->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(text);
  label->setMinimumWidth(0);
  line->addWidget(label, 1);
  line->addWidget(editor);
  holder->setToolTip(toolTip);
  body->addWidget(holder);
  return holder;
}

NumberControl* sliderRow(QVBoxLayout* body, QWidget* parent, const QString& text,
                         const SliderScale& scale, const QString& unit, const QString& toolTip) {
  auto* control = new NumberControl(scale, unit, parent);
  row(body, text, control->box(), toolTip);
  control->slider()->setToolTip(toolTip);
  body->addWidget(control->slider());
  return control;
}

QWidget* sliderGroup(QVBoxLayout* body, const QString& text, NumberControl* control,
                     const QString& toolTip) {
  auto* group = new QWidget;
  auto* lines = new QVBoxLayout(group);
  lines->setContentsMargins(0, 0, 0, 0);
  row(lines, text, control->box(), toolTip);
  control->slider()->setToolTip(toolTip);
  lines->addWidget(control->slider());
  body->addWidget(group);
  return group;
}

QComboBox* choices(std::initializer_list<std::pair<QString, int>> items) {
  auto* box = new QComboBox;
  for (const auto& [text, value] : items) box->addItem(text, value);
  ignoreWheelWithoutFocus(box);
  return box;
}

void select(QComboBox* box, int value, const QString& textWhereAbsent) {
  if (box->findData(value) < 0) box->addItem(textWhereAbsent, value);
  box->setCurrentIndex(box->findData(value));
}

void refuseItems(QComboBox* box, const std::function<QString(int)>& why) {
  auto* items = qobject_cast<QStandardItemModel*>(box->model());
  for (int row = 0; row < items->rowCount(); ++row) {
    QStandardItem* item = items->item(row);
    const QString reason = why(item->data(Qt::UserRole).toInt());
    item->setEnabled(reason.isEmpty());
    item->setToolTip(reason);
  }
}

}  // namespace umbra
