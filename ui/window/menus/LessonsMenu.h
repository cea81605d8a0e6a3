// The lessons, and the steps of the one that is read.
#pragma once

#include <QMenu>

namespace umbra {

class FileActions;
class LessonController;
class LessonVisit;

class LessonsMenu : public QMenu {
  Q_OBJECT

 public:
  LessonsMenu(LessonController& lessons, LessonVisit& visit, FileActions& files,
              QWidget* parent = nullptr);

 private:
  void addLessons(LessonVisit& visit, FileActions& files);
  void addSteps(LessonVisit& visit);
  void refresh();

  LessonController& lessons_;
  QAction *next_ = nullptr, *back_ = nullptr, *again_ = nullptr, *leave_ = nullptr;
};

}  // namespace umbra
