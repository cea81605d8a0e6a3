// The question of a lesson's step: a prediction by slider or number, then prediction, measurement
// and cause side by side.
#pragma once

#include <QFrame>

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace umbra {

class LessonController;

class LessonQuestionPane : public QFrame {
  Q_OBJECT

 public:
  explicit LessonQuestionPane(LessonController& lessons, QWidget* parent = nullptr);

  QSlider* slider() { return slider_; }
  QDoubleSpinBox* field() { return field_; }
  QPushButton* button() { return button_; }
  // The measurement as it stands beside the prediction; empty until a prediction was given.
  QString measuredText() const;
  QString verdict() const;

  // Must be called after another step is shown, and after a prediction.
  void refresh();
  void awaitPrediction();  // the field takes the keyboard

 signals:
  void answered();

 private:
  QWidget* makeEntry();
  QWidget* makeAnswer();
  void refreshText();
  void refreshAnswer();
  void predict();

  LessonController& lessons_;
  double low_ = 0.0, high_ = 1.0;  // of a prediction
  QLabel* text_;
  QWidget *entry_, *answer_;
  QSlider* slider_;
  QDoubleSpinBox* field_;
  QPushButton* button_;
  QLabel *predicted_, *measured_, *quantity_, *verdict_, *cause_, *explanation_;
};

}  // namespace umbra
