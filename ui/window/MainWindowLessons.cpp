// The window's lessons: their menu, their dock, and going in and out.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "datasets/lessons/LessonCatalogue.h"
#include "ui/lessons/LessonController.h"
#include "ui/lessons/LessonPane.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/MainWindow.h"

namespace umbra {

void MainWindow::makeLessonDock() {
  lessonPane_ = new LessonPane(*lessons_);
  lessonDock_ = addDock(tr("Lesson"), "lessonDock", lessonPane_, Qt::LeftDockWidgetArea);
  docks_.pop_back();
  lessonDock_->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  lessonDock_->hide();
  connect(lessonPane_, &LessonPane::leaveRequested, this, &MainWindow::leaveLesson);
}

void MainWindow::makeLessonsMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Lessons"));
  menu->setObjectName("lessonsMenu");
  menu->setToolTipsVisible(true);
  for (const Lesson& lesson : lessonCatalogue()) {
    QAction* action =
        addAction(*menu, style::text(lesson.title), {}, [this, lesson] { enterLesson(lesson); });
    action->setToolTip(style::text(lesson.summary));
    action->setData(style::text(lesson.name));
  }
  menu->addSeparator();
  addAction(*menu, tr("&Open lesson …"), {},
            [this] { askToOpen(tr("Open lesson"), tr("Lesson (*.json)")); });
  menu->addSeparator();
  QAction* next =
      addAction(*menu, tr("&Next step"), QKeySequence("Alt+Right"), [this] { lessons_->next(); });
  QAction* back =
      addAction(*menu, tr("Step &before"), QKeySequence("Alt+Left"), [this] { lessons_->back(); });
  QAction* again =
      addAction(*menu, tr("This step from its &beginning"), {}, [this] { lessons_->restart(); });
  QAction* leave = addAction(*menu, tr("&Leave the lesson"), {}, [this] { leaveLesson(); });
  const auto refresh = [=, this] {
    const auto& progress = lessons_->progress();
    next->setEnabled(progress && !progress->atLast());
    back->setEnabled(progress && !progress->atFirst());
    for (QAction* action : {again, leave}) action->setEnabled(progress.has_value());
  };
  connect(lessons_, &LessonController::changed, this, refresh);
  refresh();
}

void MainWindow::enterLesson(const Lesson& lesson) {
  const bool entering = !lessons_->progress();
  if (entering) {  // where the probe is now is part of what waits
    controller_.amend([own = sessionToSave()](Session& session) { session = own; });
    pointBefore_ = prober_->pinnedPoint();
    layoutBefore_ = saveState();
    controlsWidth_ = docks_.front()->width();
  }
  lessons_->enter(lesson);
  if (entering) placeLessonDock();
}

void MainWindow::leaveLesson() {
  if (!lessons_->progress()) return;
  lessons_->leave();
  prober_->holdPoint(pointBefore_);
  probeNextFrame_ = false;  // one's own session comes back as it was, with or without a probe
  restoreOwnLayout();
}

void MainWindow::restoreOwnLayout() {
  restoreState(layoutBefore_);
  lessonDock_->hide();
  resizeDocks({docks_.front()}, {controlsWidth_}, Qt::Horizontal);
}

// On top of the controls: what is read takes the place of what is set.
void MainWindow::placeLessonDock() {
  if (!lessons_->progress()) return lessonDock_->hide();
  lessonDock_->setFloating(false);
  tabifyDockWidget(docks_.front(), lessonDock_);
  lessonDock_->show();
  lessonDock_->raise();
  resizeDocks({lessonDock_}, {width() < 1500 ? 340 : 400}, Qt::Horizontal);
}

}  // namespace umbra
