// The controls: the technique, its parameters, filter and map.
#pragma once

#include <QScrollArea>
#include <QString>

#include "filters/core/support/Parameters.h"

class QLabel;

namespace umbra {

class FrameSettingsForm;
class ParameterForm;
class Prober;
class ReductionTools;
class SceneView;
class SessionController;
class TechniqueList;

class ControlPane : public QScrollArea {
  Q_OBJECT

 public:
  ControlPane(SessionController& controller, Prober& prober, SceneView& view,
              QWidget* parent = nullptr);

  TechniqueList& techniques() { return *techniques_; }
  ParameterForm& parameters() { return *parameters_; }
  FrameSettingsForm& frame() { return *frame_; }
  ReductionTools& reduction() { return *reduction_; }

  QSize sizeHint() const override { return {268, 400}; }

 private:
  void refresh();
  QString scope() const;
  void changeParameter(const QString& name, const ParameterValue& value);

  SessionController& controller_;
  QLabel* scope_;  // which panes of a comparison the controls are about
  TechniqueList* techniques_;
  ParameterForm* parameters_;
  FrameSettingsForm* frame_;
  ReductionTools* reduction_;
};

}  // namespace umbra
