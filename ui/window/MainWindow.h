// The window: puts its parts together and connects them; holds no state but what is open.
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <vector>

#include "ui/session/SessionController.h"

class QDockWidget;

namespace umbra {

class BleedingExport;
class CentrePane;
class ControlPane;
class EvidencePanes;
class FileActions;
class FileDialogs;
class ImportSheet;
class SavedProbes;
class SavedProbesPane;
class LessonController;
class LessonPane;
class LessonVisit;
class Prober;
class SceneView;
class SessionPresenter;
class StatusLine;
class SurfaceExport;
class TableExport;
class WatchedPanes;
class WindowDocks;
struct Lesson;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  // Throws BadInput where the session's source cannot be read.
  explicit MainWindow(const Workspace& workspace, QWidget* parent = nullptr);
  ~MainWindow() override;

  SessionController& controller() { return controller_; }
  SceneView& view() { return *view_; }
  Prober& prober() { return *prober_; }
  EvidencePanes& evidence() { return *evidence_; }
  ControlPane& controls() { return *controls_; }
  CentrePane& centre() { return *centre_; }
  SavedProbes& savedProbes() { return *saved_; }
  SavedProbesPane& savedProbesPane() { return *savedPane_; }
  LessonController& lessons() { return *lessons_; }
  LessonPane& lessonPane();
  SurfaceExport& surfaces();
  ImportSheet& importSheet() { return *import_; }
  const std::vector<QDockWidget*>& docks() const;

  // See ui/window/files/SavedSession.h.
  Workspace sessionToSave() const;
  Workspace sessionToRemember() const;

  // See FileActions and BleedingExport.
  void openFile(const std::filesystem::path& file);
  void saveSession(const std::filesystem::path& file);
  void savePicture(const std::filesystem::path& file);
  void exportBleeding(const std::filesystem::path& file);

  void enterLesson(const Lesson& lesson);
  void leaveLesson();
  void resetLayout();

 signals:
  void closing();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void makeDocks();
  void makeFileActions();
  void makeMenus();
  void connectMessages();
  void showTitle();

  SessionController controller_;
  SceneView* view_;
  Prober* prober_;
  EvidencePanes* evidence_;
  ControlPane* controls_;
  CentrePane* centre_;
  SavedProbes* saved_;
  SavedProbesPane* savedPane_;
  LessonController* lessons_;
  WatchedPanes* watched_ = nullptr;
  WindowDocks* docks_ = nullptr;
  LessonVisit* visit_ = nullptr;
  FileDialogs* dialogs_ = nullptr;
  FileActions* files_ = nullptr;
  ImportSheet* import_ = nullptr;
  TableExport* tables_ = nullptr;
  BleedingExport* bleeding_ = nullptr;
  SessionPresenter* presenter_ = nullptr;
  StatusLine* status_ = nullptr;
};

}  // namespace umbra
