// Into a lesson and out of it again: its dock, and what of the window waits meanwhile.
#pragma once

#include <Eigen/Core>
#include <QByteArray>
#include <QObject>
#include <optional>

class QDockWidget;
class QMainWindow;

namespace umbra {

class LessonController;
class LessonPane;
class Prober;
class SceneView;
class SessionController;
class WindowDocks;
struct Lesson;

class LessonVisit : public QObject {
  Q_OBJECT

 public:
  LessonVisit(QMainWindow& window, WindowDocks& docks, SessionController& controller,
              SceneView& view, Prober& prober, LessonController& lessons);

  LessonPane& pane() { return *pane_; }
  // The window's own session waits until the lesson is left.
  void enter(const Lesson& lesson);
  // The docks as they were before the lesson, which must have been entered.
  void restoreLayout();

 public slots:
  void leave();

 signals:
  void left();

 private:
  void placeDock();

  QMainWindow& window_;
  WindowDocks& docks_;
  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  LessonController& lessons_;
  LessonPane* pane_;
  QDockWidget* dock_;  // in sight during a lesson alone
  // Before the lesson: the arrangement of the docks, the width of the controls, and where the probe
  // is pinned (world).
  QByteArray layoutBefore_;
  int controlsWidth_ = 0;
  std::optional<Eigen::Vector3d> pointBefore_;
};

}  // namespace umbra
