#include "ui/widgets/forms/FrameSettingsForm.h"

#include <QLabel>
#include <QVBoxLayout>

#include "filters/core/settings/SettingsTable.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/SettingEditor.h"

namespace umbra {

FrameSettingsForm::FrameSettingsForm(QWidget* parent)
    : Card(tr("Filter and map"), parent), samplesNotice_(new QLabel) {
  samplesNotice_->setObjectName("samples notice");
  samplesNotice_->setWordWrap(true);
  samplesNotice_->setMinimumWidth(0);
  samplesNotice_->hide();
  addRows("Technique and prefilter");
  addRows("Read of the shaded frame");
  addRows("Shadow map");
  addRows("View");
  body()->addStretch();
  showSettings();
}

void FrameSettingsForm::addRows(std::string_view group) {
  for (const auto& declared : frameTable()) {
    // The view itself is chosen by its buttons above the picture.
    if (declared.info.group != group || declared.info.name == "view.mode") continue;
    SettingEditor* row = SettingEditor::make(bound(declared, shown_), this);
    body()->addWidget(row);
    rows_.push_back(row);
    if (declared.info.name == "map.samples") body()->addWidget(samplesNotice_);
    const QString noun = style::text(declared.info.noun);
    connect(row, &SettingEditor::changed, this, [this, noun] {
      showSettings();
      emit settingsChanged(shown_, noun);
    });
    connect(row, &SettingEditor::finished, this, [this, noun] { emit editingFinished(noun); });
  }
}

void FrameSettingsForm::setSettings(const FrameSettings& settings) {
  shown_ = settings;
  showSettings();
}

FrameSettings FrameSettingsForm::settings() const {
  return shown_;
}

void FrameSettingsForm::showSettings() {
  Kernel automatic = shown_.kernel;
  automatic.sigma = 0.0;
  for (SettingEditor* row : rows_) {
    row->follow();
    if (row->info().name == "kernel.sigma")
      row->setAutomaticText(tr("auto %1").arg(style::figure(automatic.effectiveSigma())));
  }
  showObstacles();
  showGivenSamples();
}

// A choice is greyed out for what it alone brings: not for what is impossible already.
void FrameSettingsForm::showObstacles() {
  if (!obstacle_) return;
  const QString present = obstacle_(shown_);
  for (SettingEditor* row : rows_)
    row->refuseChoices([&](const SettingValue& value) {
      FrameSettings changed = shown_;
      for (const auto& declared : frameTable())
        if (declared.info.name == row->info().name) declared.putInto(changed, value);
      const QString reason = obstacle_(changed);
      return reason == present ? QString() : reason;
    });
}

void FrameSettingsForm::setObstacle(std::function<QString(const FrameSettings&)> obstacle) {
  obstacle_ = std::move(obstacle);
  showObstacles();
}

void FrameSettingsForm::setCamera(const Camera& camera) {
  for (SettingEditor* row : rows_) row->setCamera(camera);
}

void FrameSettingsForm::showGivenSamples() {
  const bool fewer = givenSamples_ > 0 && givenSamples_ < shown_.map.samples;
  samplesNotice_->setText(tr("The driver gives %1").arg(givenSamples_));
  samplesNotice_->setVisible(fewer);
}

void FrameSettingsForm::setGivenSamples(int samples) {
  if (samples == givenSamples_) return;
  givenSamples_ = samples;
  showGivenSamples();
}

}  // namespace umbra
