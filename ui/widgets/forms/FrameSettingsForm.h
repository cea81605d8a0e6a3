// "Filter and map": every setting of a frame but its view, as the table declares it. Rows that do
// nothing are hidden.
#pragma once

#include <QMetaType>
#include <functional>
#include <string_view>
#include <vector>

#include "filters/core/settings/FrameSettings.h"
#include "ui/widgets/base/Card.h"

namespace umbra {

class SettingEditor;

class FrameSettingsForm : public Card {
  Q_OBJECT

 public:
  explicit FrameSettingsForm(QWidget* parent = nullptr);

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
  // All settings, one of which changed; `whatChanged` is its noun in the table, for undo. Emitted
  // while a slider moves.
  void settingsChanged(const umbra::FrameSettings& settings, const QString& whatChanged);
  // A slider was let go or a box was left: the next change is a new step for undo.
  void editingFinished(const QString& what);

 private:
  void addRows(std::string_view group);
  void showSettings();  // the settings into the rows
  void showObstacles();
  void showGivenSamples();

  FrameSettings shown_;
  std::function<QString(const FrameSettings&)> obstacle_;
  int givenSamples_ = 0;
  std::vector<SettingEditor*> rows_;  // bound to `shown_`
  QLabel* samplesNotice_ = nullptr;
};

}  // namespace umbra

Q_DECLARE_METATYPE(umbra::FrameSettings)
