#include "ui/window/menus/LightForm.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

Light lightOf(const Document& document) {
  if (document.session.light) return *document.session.light;
  return document.content.scene ? document.content.scene->light : Light{};
}

QSlider* sliderRow(QFormLayout& form, const QString& name, int low, int high, QLabel*& text) {
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setRange(low, high);
  slider->setMinimumWidth(140);
  text = new QLabel;
  text->setFont(style::figures(text->font()));
  text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  text->setMinimumWidth(44);
  auto* row = new QHBoxLayout;
  row->addWidget(slider, 1);
  row->addWidget(text);
  form.addRow(name, row);
  return slider;
}

}  // namespace

LightForm::LightForm(SessionController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller), kind_(new QComboBox) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(14, 10, 14, 10);
  setStyleSheet(style::sheet());
  kind_->addItems({tr("Directional"), tr("Spot")});
  form->addRow(tr("Kind"), kind_);
  angle_ = sliderRow(*form, tr("Half angle"), 5, 60, angleText_);
  intensity_ = sliderRow(*form, tr("Intensity"), 10, 400, intensityText_);
  auto* reset = new QPushButton(tr("Back to the scene's light"));
  form->addRow(reset);
  auto* hint = new QLabel(tr("Drag the sun in the picture to move the light."));
  hint->setStyleSheet(QString("color: %1").arg(style::muted.name()));
  form->addRow(hint);

  const auto edit = [this](const QString& text, const QString& key, auto change) {
    const Light shown = lightOf(controller_.document());
    controller_.edit(
        text,
        [&](Session& session) {
          session.light = shown;
          change(*session.light);
        },
        key);
  };
  connect(kind_, QOverload<int>::of(&QComboBox::activated), this, [edit](int index) {
    edit(tr("Change light kind"), {}, [&](Light& light) { light.kind = LightKind(index); });
  });
  connect(angle_, &QSlider::valueChanged, this, [edit](int degrees) {
    edit(tr("Change half angle"), "light angle", [&](Light& light) { light.halfAngle = degrees; });
  });
  connect(intensity_, &QSlider::valueChanged, this, [edit](int hundredths) {
    edit(tr("Change intensity"), "light intensity",
         [&](Light& light) { light.intensity = hundredths / 100.0; });
  });
  for (QSlider* slider : {angle_, intensity_})
    connect(slider, &QSlider::sliderReleased, this, [this] { controller_.endMerge(); });
  connect(reset, &QPushButton::clicked, this, [this] {
    controller_.edit(tr("Reset light"), [](Session& session) { session.light.reset(); });
  });
  connect(&controller_, &SessionController::changed, this, &LightForm::refresh);
  refresh();
}

void LightForm::refresh() {
  const QSignalBlocker kind(kind_), angle(angle_), intensity(intensity_);
  const Light light = lightOf(controller_.document());
  setEnabled(controller_.document().content.scene != nullptr);
  kind_->setCurrentIndex(int(light.kind));
  angle_->setValue(int(std::lround(light.halfAngle)));
  angle_->setEnabled(light.kind == LightKind::Spot);
  intensity_->setValue(int(std::lround(light.intensity * 100.0)));
  angleText_->setText(QString::number(light.halfAngle, 'f', 0) + QChar(0x00b0));
  intensityText_->setText(QString::number(light.intensity, 'f', 2));
}

}  // namespace umbra
