#include "ui/window/menus/SceneForm.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <cmath>

#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int steps = 200;

SceneInfo infoOf(const SceneSource& source) {
  if (source.kind == SourceKind::Catalogue)
    for (const SceneInfo& info : sceneCatalogue())
      if (info.name == source.name) return info;
  return {};
}

}  // namespace

SceneForm::SceneForm(SessionController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller), form_(new QFormLayout(this)) {
  form_->setContentsMargins(14, 10, 14, 10);
  setStyleSheet(style::sheet());
  connect(&controller_, &SessionController::changed, this,
          [this](const Document& before, const Document& after) {
            if (!(before.session.source == after.session.source)) refresh();
          });
  refresh();
}

void SceneForm::refresh() {
  const SceneSource& source = controller_.session().source;
  shown_ = infoOf(source);
  while (form_->rowCount() > 0) form_->removeRow(0);
  for (SceneParameter parameter : shown_.parameters) {
    const auto set = source.parameters.find(parameter.name);
    if (set != source.parameters.end()) parameter.value = set->second;
    addRow(parameter);
  }
  adjustSize();
}

void SceneForm::addRow(const SceneParameter& parameter) {
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setObjectName(style::text(parameter.name));
  slider->setRange(0, steps);
  slider->setMinimumWidth(160);
  slider->setTracking(false);  // a scene is built anew when the slider is let go
  slider->setToolTip(style::text(parameter.doc));
  const double low = parameter.low, range = parameter.high - parameter.low;
  slider->setValue(int(std::lround((parameter.value - low) / range * steps)));
  auto* text = new QLabel(style::figure(parameter.value));
  text->setFont(style::figures(text->font()));
  text->setMinimumWidth(52);
  text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* row = new QHBoxLayout;
  row->addWidget(slider, 1);
  row->addWidget(text);
  form_->addRow(style::label(parameter.name), row);
  const auto valueAt = [low, range](int step) { return low + range * step / steps; };
  connect(slider, &QSlider::sliderMoved, text,
          [=](int step) { text->setText(style::figure(valueAt(step))); });
  connect(slider, &QSlider::valueChanged, this,
          [=, this, name = parameter.name](int step) { change(name, valueAt(step)); });
}

// Light, camera and probe stay as they are, so that the change of the scene itself can be studied.
void SceneForm::change(const std::string& name, double value) {
  SceneSource source = controller_.session().source;
  source.parameters[name] = value;
  controller_.reread(source);
}

}  // namespace umbra
