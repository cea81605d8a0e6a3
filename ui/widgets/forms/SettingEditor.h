// Shows and edits one setting as a row of a form: see filters/core/settings/Setting.h.
#pragma once

#include <QMetaType>
#include <QWidget>
#include <functional>

#include "filters/core/scene/Camera.h"
#include "filters/core/settings/Setting.h"

class QComboBox;
class QVBoxLayout;

namespace umbra {

class SettingEditor : public QWidget {
  Q_OBJECT

 public:
  // Makes the row that suits the setting's kind. The values that the setting is bound to must
  // outlive it.
  static SettingEditor* make(const Setting& setting, QWidget* parent);

  const SettingInfo& info() const { return setting_.info; }
  // Shows the value as it is, and hides or greys out the row where the setting does nothing; emits
  // nothing.
  void follow();
  // Sets the text that is shown for 0 if 0 is automatic.
  virtual void setAutomaticText(const QString&) {}
  // Sets the camera that is stored when a camera is switched on.
  void setCamera(const Camera& camera) { camera_ = camera; }
  // Greys out the choices for which `why` gives a reason, which becomes their tool tip.
  virtual void refuseChoices(const std::function<QString(const SettingValue&)>&) {}

 signals:
  // The setting has a new value within its range. This is emitted while a slider moves as well.
  void changed();
  void finished();  // a slider was let go, a box was left or a choice was made

 protected:
  SettingEditor(const Setting& setting, QWidget* parent);
  virtual void showValue(const SettingValue& value) = 0;

  void take(const SettingValue& value);
  const Camera& camera() const { return camera_; }
  // Puts the title at the left and the editor at the right end.
  void addTitled(QWidget* editor);
  void addBeneath(QWidget* editor);  // over the whole width

 private:
  Setting setting_;
  Camera camera_;
  QVBoxLayout* lines_;
};

}  // namespace umbra
