// The window's menu bar.
#pragma once

#include <QObject>

class QAction;
class QMainWindow;

namespace umbra {

class BleedingExport;
class EvidencePanes;
class ExportMenu;
class FileActions;
class ImportSheet;
class SavedProbes;
class LessonController;
class LessonVisit;
class Prober;
class SceneMenu;
class SessionController;
class TableExport;
class ViewMenu;
class WindowDocks;

// The parts of the window that its menus act upon.
struct MenuSubjects {
  SessionController& controller;
  Prober& prober;
  SavedProbes& saved;
  EvidencePanes& evidence;
  FileActions& files;
  ImportSheet& sheet;
  TableExport& tables;
  BleedingExport& bleeding;
  WindowDocks& docks;
  LessonController& lessons;
  LessonVisit& visit;
};

class WindowMenus : public QObject {
  Q_OBJECT

 public:
  WindowMenus(QMainWindow& window, const MenuSubjects& subjects);

  // These menus are shown by the tool bar as well.
  SceneMenu& scene() { return *scene_; }
  ExportMenu& exports() { return *export_; }
  ViewMenu& view() { return *view_; }

 private:
  void addFileMenu();
  void addEditMenu();
  void addProbeMenu();
  void addWindowMenu();

  QMainWindow& window_;
  MenuSubjects subjects_;
  SceneMenu* scene_;
  ExportMenu* export_;
  ViewMenu* view_ = nullptr;
  QAction* reading_ = nullptr;
};

}  // namespace umbra
