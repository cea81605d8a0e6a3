#include "ui/window/menus/LessonsMenu.h"

#include "datasets/lessons/LessonCatalogue.h"
#include "ui/lessons/LessonController.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/docks/LessonVisit.h"
#include "ui/window/files/FileActions.h"
#include "ui/window/menus/MenuActions.h"

namespace umbra {

LessonsMenu::LessonsMenu(LessonController& lessons, LessonVisit& visit, FileActions& files,
                         QWidget* parent)
    : QMenu(tr("&Lessons"), parent), lessons_(lessons) {
  setObjectName("lessonsMenu");
  setToolTipsVisible(true);
  addLessons(visit, files);
  addSeparator();
  addSteps(visit);
  connect(&lessons_, &LessonController::changed, this, &LessonsMenu::refresh);
  refresh();
}

void LessonsMenu::addLessons(LessonVisit& visit, FileActions& files) {
  for (const Lesson& lesson : lessonCatalogue()) {
    QAction* action = umbra::addAction(*this, style::text(lesson.title), {},
                                       [&visit, lesson] { visit.enter(lesson); });
    action->setToolTip(style::plainTip(style::text(lesson.summary)));
    action->setData(style::text(lesson.name));
  }
  addSeparator();
  umbra::addAction(*this, tr("&Open lesson …"), {},
                   [&files] { files.askToOpen(tr("Open lesson"), tr("Lesson (*.json)")); });
}

void LessonsMenu::addSteps(LessonVisit& visit) {
  next_ = umbra::addAction(*this, tr("&Next step"), QKeySequence("Alt+Right"),
                           [this] { lessons_.next(); });
  back_ = umbra::addAction(*this, tr("Step &before"), QKeySequence("Alt+Left"),
                           [this] { lessons_.back(); });
  again_ = umbra::addAction(*this, tr("This step from its &beginning"), {},
                            [this] { lessons_.restart(); });
  leave_ = umbra::addAction(*this, tr("&Leave the lesson"), {}, [&visit] { visit.leave(); });
}

void LessonsMenu::refresh() {
  const auto& progress = lessons_.progress();
  next_->setEnabled(progress && !progress->atLast());
  back_->setEnabled(progress && !progress->atFirst());
  for (QAction* action : {again_, leave_}) action->setEnabled(progress.has_value());
}

}  // namespace umbra
