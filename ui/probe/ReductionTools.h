// Finds the smallest light-bleeding reduction, for the probed region and for the whole picture.
#pragma once

#include <QWidget>

#include "analysis/errors/BleedReduction.h"

class QLabel;
class QPushButton;

namespace umbra {

class Prober;
class SceneView;
class SessionController;

class ReductionTools : public QWidget {
  Q_OBJECT

 public:
  ReductionTools(SessionController& controller, Prober& prober, SceneView& view,
                 QWidget* parent = nullptr);

  // After a change of the session: shown for techniques that have the parameter, and what was said
  // of another state is taken back.
  void refresh();
  // After a new probe, or none.
  void followProbe();
  QString said() const;

 public slots:
  void findForRegion();
  void findForFrame();

 signals:
  void amountFound(double amount);
  void failed(const QString& message);

 private:
  BleedReduction measureFrame() const;
  void take(const BleedReduction& found, const QString& removes, const QString& place);

  SessionController& controller_;
  Prober& prober_;
  SceneView& view_;
  QPushButton *region_, *frame_;
  QLabel* said_;
  bool taking_ = false;  // the change of session that follows is this widget's own
};

}  // namespace umbra
