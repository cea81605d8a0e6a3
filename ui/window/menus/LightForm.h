// The casting light's kind, cone and brightness; where it stands is dragged in the picture.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;

namespace umbra {

class SessionController;

class LightForm : public QWidget {
  Q_OBJECT

 public:
  explicit LightForm(SessionController& controller, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionController& controller_;
  QComboBox* kind_;
  QSlider *angle_, *intensity_;  // degrees; hundredths
  QLabel *angleText_, *intensityText_;
};

}  // namespace umbra
