// "Filter and map": prefilter, read, map size, storage format and bias.
#pragma once

#include <QMetaType>
#include <map>
#include <memory>

#include "filters/core/FrameSettings.h"
#include "ui/widgets/Card.h"

namespace umbra {

class FrameSettingsForm : public Card {
  Q_OBJECT

 public:
  explicit FrameSettingsForm(QWidget* parent = nullptr);
  ~FrameSettingsForm() override;

  // Shows the settings; emits nothing. The view mode is kept but not shown.
  void setSettings(const FrameSettings& settings);
  FrameSettings settings() const;

  // Greys out the formats that cannot be chosen; each with its reason, as a tool tip.
  void setFormatRefusals(const std::map<StorageFormat, QString>& reasons);
  // A line at the end, such as "bake 3.1 · blur 1.4 · shade 6.0 ms"; empty hides it.
  void setGpuText(const QString& text);

 signals:
  // All settings, one of which changed; `whatChanged` names it for undo: "kernel", "radius",
  // "sigma", "read", "map size", "format", "constant bias", "slope bias", "receiver plane",
  // "front-face culling". Emitted while a slider moves.
  void settingsChanged(const umbra::FrameSettings& settings, const QString& whatChanged);
  // A slider was let go or a box was left: the next change is a new step for undo.
  void editingFinished(const QString& what);

 private:
  struct Controls;
  void connectControls();
  void showSettings();  // the settings into the controls
  void change(const QString& what);

  FrameSettings shown_;
  std::unique_ptr<Controls> controls_;
};

}  // namespace umbra

Q_DECLARE_METATYPE(umbra::FrameSettings)
