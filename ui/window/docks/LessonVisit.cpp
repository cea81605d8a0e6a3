#include "ui/window/docks/LessonVisit.h"

#include <QDockWidget>
#include <QMainWindow>

#include "ui/lessons/LessonController.h"
#include "ui/lessons/LessonPane.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/window/docks/WindowDocks.h"
#include "ui/window/files/SavedSession.h"

namespace umbra {

LessonVisit::LessonVisit(QMainWindow& window, WindowDocks& docks, SessionController& controller,
                         SceneView& view, Prober& prober, LessonController& lessons)
    : QObject(&window),
      window_(window),
      docks_(docks),
      controller_(controller),
      view_(view),
      prober_(prober),
      lessons_(lessons),
      pane_(new LessonPane(lessons)),
      dock_(docks.makeDock(tr("Lesson"), "lessonDock", *pane_, Qt::LeftDockWidgetArea)) {
  dock_->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  dock_->hide();
  connect(pane_, &LessonPane::leaveRequested, this, &LessonVisit::leave);
  connect(&docks_, &WindowDocks::arranged, this, &LessonVisit::placeDock);
}

void LessonVisit::enter(const Lesson& lesson) {
  const bool entering = !lessons_.progress();
  if (entering) {  // where the probe is now is part of what waits
    const Session own = sessionOf(sessionToSave(controller_, view_, prober_));
    controller_.amend([&](Session& session) { session = own; });
    pointBefore_ = prober_.pinnedPoint();
    layoutBefore_ = window_.saveState();
    controlsWidth_ = docks_.controls().width();
  }
  lessons_.enter(lesson);
  if (entering) placeDock();
}

void LessonVisit::leave() {
  if (!lessons_.progress()) return;
  lessons_.leave();
  prober_.holdPoint(pointBefore_);
  emit left();
  restoreLayout();
}

void LessonVisit::restoreLayout() {
  window_.restoreState(layoutBefore_);
  dock_->hide();
  window_.resizeDocks({&docks_.controls()}, {controlsWidth_}, Qt::Horizontal);
}

// The lesson lies on top of the controls: what is read takes the place of what is set.
void LessonVisit::placeDock() {
  if (!lessons_.progress()) return dock_->hide();
  dock_->setFloating(false);
  window_.tabifyDockWidget(&docks_.controls(), dock_);
  dock_->show();
  dock_->raise();
  window_.resizeDocks({dock_}, {window_.width() < 1500 ? 340 : 400}, Qt::Horizontal);
}

}  // namespace umbra
