// The window: puts the panes together and connects them; holds no state but what is open.
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <optional>
#include <vector>

#include "ui/session/SessionController.h"

class QActionGroup;
class QDockWidget;
class QLabel;
class QMenu;
class QToolButton;

namespace umbra {

class CentrePane;
class ControlPane;
class EvidencePanes;
class KeptProbes;
class KeptProbesPane;
class LessonController;
class LessonPane;
class PlotPane;
class Prober;
class SceneForm;
class SceneView;
class SurfaceExport;
struct Lesson;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  // Throws BadInput where the session's source cannot be read.
  explicit MainWindow(const Session& session, QWidget* parent = nullptr);
  ~MainWindow() override;

  SessionController& controller() { return controller_; }
  SceneView& view() { return *view_; }
  Prober& prober() { return *prober_; }
  EvidencePanes& evidence() { return *evidence_; }
  ControlPane& controls() { return *controls_; }
  CentrePane& centre() { return *centre_; }
  KeptProbes& keptProbes() { return *kept_; }
  KeptProbesPane& keptProbesPane() { return *keptPane_; }
  LessonController& lessons() { return *lessons_; }
  LessonPane& lessonPane() { return *lessonPane_; }
  const std::vector<QDockWidget*>& docks() const { return docks_; }

  // What a saved session holds: the picture's size and the pinned pixel as they are now.
  Session sessionToSave() const;
  // One's own, also while a lesson shows another.
  Session sessionToRemember() const;

  // By extension: a mesh, a depth map (.exr), a session or a lesson (.json); read beside this
  // thread.
  void openFile(const std::filesystem::path& file);
  // The window's own session waits until the lesson is left.
  void enterLesson(const Lesson& lesson);
  // Throw BadOutput.
  void saveSession(const std::filesystem::path& file);
  void savePicture(const std::filesystem::path& file);  // PNG, as shown with the probe
  // The session's technique's error on the scene's mesh, .vtp or .ply; written beside this thread.
  // Throws where the session has no such thing.
  void exportBleeding(const std::filesystem::path& file);
  SurfaceExport& surfaces() { return *surfaces_; }

 public slots:
  void showError(const QString& text);
  void showNotices();
  void resetLayout();
  void leaveLesson();

 signals:
  void closing();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  // MainWindow.cpp
  void connectParts();
  void refresh();
  void showFrameFigures();
  void afterFrame();
  void restoreOwnLayout();  // as it was before the lesson
  // MainWindowDocks.cpp
  void makeDocks();
  void makeWatchedDocks();
  QDockWidget* addDock(const QString& title, const QString& name, QWidget* content,
                       Qt::DockWidgetArea area);
  // MainWindowMenus.cpp
  void makeActions();
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeTechniqueMenu();
  void makeProbeMenu();
  void makeWindowMenu();
  void makeHelpMenu();
  void makeToolBar();
  QMenu* makeSceneMenu();
  QMenu* makeExportMenu();
  QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& key,
                     const std::function<void()>& run);
  // MainWindowLessons.cpp
  void makeLessonDock();
  void makeLessonsMenu();
  void placeLessonDock();
  // MainWindowCompare.cpp
  void makeCompareMenu(QMenu& view);
  void refreshCompareMenu();
  // MainWindowSurfaces.cpp
  void makeSurfaceExport();
  void askToExportBleeding();
  QString whyNoSurfaces() const;
  // MainWindowFiles.cpp
  void askToOpen(const QString& title, const QString& filter);
  void askToSaveSession();
  void askToSavePicture();
  void askToSaveTable();
  void askToSaveKeptProbes();
  std::optional<std::filesystem::path> askWhere(const QString& title, const QString& name,
                                                const QString& filter);
  void attempt(const std::function<void()>& work);

  SessionController controller_;
  SceneView* view_;
  Prober* prober_;
  EvidencePanes* evidence_;
  ControlPane* controls_;
  CentrePane* centre_;
  KeptProbes* kept_;
  KeptProbesPane* keptPane_;
  LessonController* lessons_;
  LessonPane* lessonPane_ = nullptr;
  SurfaceExport* surfaces_ = nullptr;
  // What waits beside the session while a lesson is read: the docks and where the probe is held.
  QByteArray layoutBefore_;
  int controlsWidth_ = 0;
  std::optional<Eigen::Vector3d> pointBefore_;
  QDockWidget* lessonDock_ = nullptr;  // not among docks_: it is there during a lesson alone
  std::vector<QDockWidget*> docks_;
  QActionGroup *modes_, *techniques_, *comparisons_ = nullptr;
  QAction* duplicate_ = nullptr;
  QToolButton *sceneButton_ = nullptr, *adjustButton_ = nullptr;
  SceneForm* sceneForm_ = nullptr;
  QMenu *sceneMenu_ = nullptr, *exportMenu_ = nullptr;
  QLabel *sceneText_, *frameText_, *mapText_;
  bool probeNextFrame_ = true;  // a scene was opened and nobody has pointed at anything yet
};

}  // namespace umbra
