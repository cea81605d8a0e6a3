// The parameters of a scene of the catalogue, such as the depths of three planes.
#pragma once

#include <QWidget>

#include "datasets/scenes/SceneCatalogue.h"

class QFormLayout;
class QSlider;

namespace umbra {

class SessionController;

class SceneForm : public QWidget {
  Q_OBJECT

 public:
  explicit SceneForm(SessionController& controller, QWidget* parent = nullptr);

  // Whether the scene that is open has anything to adjust.
  bool adjustable() const { return !shown_.parameters.empty(); }

 private:
  void refresh();
  void addRow(const SceneParameter& parameter);
  void change(const std::string& name, double value);

  SessionController& controller_;
  QFormLayout* form_;
  SceneInfo shown_;
};

}  // namespace umbra
