// "Filter and map": prefilter, read, map, cascades and bias. Rows that do nothing are hidden.
#pragma once

#include <QMetaType>
#include <functional>
#include <memory>

#include "filters/core/settings/FrameSettings.h"
#include "ui/widgets/base/Card.h"

namespace umbra {

class FrameSettingsForm : public Card {
  Q_OBJECT

 public:
  explicit FrameSettingsForm(QWidget* parent = nullptr);
  ~FrameSettingsForm() override;

  // Shows the settings; emits nothing. The view mode is kept but not shown.
  void setSettings(const FrameSettings& settings);
  FrameSettings settings() const;

  // Why settings cannot be drawn, empty where they can: choices that would end there are greyed
  // out, with the reason as a tool tip.
  void setObstacle(std::function<QString(const FrameSettings&)> obstacle);
  void setCamera(const Camera& camera);  // where cascades are frozen
  // Samples a texel that the last frame had; a notice where it is fewer than are set. 0: unknown.
  void setGivenSamples(int samples);

 signals:
  // All settings, one of which changed; `whatChanged` names it for undo: "kernel", "radius",
  // "sigma", "read", "anisotropy", "box size", "box distance", "table precision", "map size",
  // "format", "samples", "cascades", "split lambda", "cascade seam", "frozen cascades", "constant
  // bias", "slope bias", "receiver plane", "front-face culling". Emitted while a slider moves.
  void settingsChanged(const umbra::FrameSettings& settings, const QString& whatChanged);
  // A slider was let go or a box was left: the next change is a new step for undo.
  void editingFinished(const QString& what);

 private:
  struct Controls;
  void makeRead();
  void makeMap();
  void connectControls();
  void showSettings();  // the settings into the controls
  void showRead();
  void showMap();
  void showObstacles();
  void change(const QString& what);

  FrameSettings shown_;
  std::function<QString(const FrameSettings&)> obstacle_;
  Camera camera_;
  int givenSamples_ = 0;
  std::unique_ptr<Controls> controls_;
};

}  // namespace umbra

Q_DECLARE_METATYPE(umbra::FrameSettings)
