// A lesson at the side of the picture: text, what to look at, the question, back and next.
#pragma once

#include "ui/widgets/base/Card.h"

class QLabel;
class QPushButton;
class QScrollArea;

namespace umbra {

class LessonController;
class LessonQuestionPane;

class LessonPane : public Card {
  Q_OBJECT

 public:
  explicit LessonPane(LessonController& lessons, QWidget* parent = nullptr);

  LessonQuestionPane& question() { return *question_; }
  QSize sizeHint() const override { return {330, 400}; }

 signals:
  void leaveRequested();

 private:
  QWidget* makePage();
  QWidget* makeNavigation();
  void refresh();
  void refreshTexts();

  LessonController& lessons_;
  QLabel *step_, *text_, *look_;
  QWidget* lookBox_;
  QLabel* place_;
  LessonQuestionPane* question_;
  QScrollArea* scroll_;
  QPushButton *back_, *next_;
  QString shown_;  // lesson and step, to scroll to the top of another one
};

}  // namespace umbra
