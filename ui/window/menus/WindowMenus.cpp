#include "ui/window/menus/WindowMenus.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>

#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/probe/SavedProbes.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/window/docks/WindowDocks.h"
#include "ui/window/files/FileActions.h"
#include "ui/window/files/FileKinds.h"
#include "ui/window/files/ImportSheet.h"
#include "ui/window/menus/ExportMenu.h"
#include "ui/window/menus/HelpMenu.h"
#include "ui/window/menus/LessonsMenu.h"
#include "ui/window/menus/MenuActions.h"
#include "ui/window/menus/RecentMenu.h"
#include "ui/window/menus/SceneMenu.h"
#include "ui/window/menus/TechniqueMenu.h"
#include "ui/window/menus/ViewMenu.h"

namespace umbra {

WindowMenus::WindowMenus(QMainWindow& window, const MenuSubjects& subjects)
    : QObject(&window),
      window_(window),
      subjects_(subjects),
      scene_(new SceneMenu(subjects.controller, subjects.files, &window)),
      export_(new ExportMenu(subjects.files, subjects.bleeding, subjects.tables, subjects.evidence,
                             &window)) {
  QMenuBar* bar = window_.menuBar();
  addFileMenu();
  addEditMenu();
  view_ = new ViewMenu(subjects_.controller, bar);
  bar->addMenu(view_);
  bar->addMenu(new TechniqueMenu(subjects_.controller, bar));
  addProbeMenu();
  bar->addMenu(new LessonsMenu(subjects_.lessons, subjects_.visit, subjects_.files, bar));
  addWindowMenu();
  bar->addMenu(new HelpMenu(subjects_.controller, window_, bar));
}

void WindowMenus::addFileMenu() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&File"));
  menu->addMenu(scene_);
  addAction(*menu, tr("&Open …"), QKeySequence::Open,
            [this] { subjects_.files.askToOpen(tr("Open"), everyFilter()); });
  menu->addMenu(new RecentMenu(subjects_.files, menu));
  reading_ = addAction(*menu, tr("&How the file is read …"), QKeySequence("Ctrl+I"),
                       [this] { subjects_.sheet.showSheet(); });
  const auto refresh = [this] { reading_->setEnabled(subjects_.sheet.available()); };
  connect(&subjects_.controller, &SessionController::changed, this, refresh);
  refresh();
  menu->addSeparator();
  addAction(*menu, tr("&Save session …"), QKeySequence::Save,
            [this] { subjects_.files.askToSaveSession(); });
  menu->addMenu(export_);
  menu->addSeparator();
  addAction(*menu, tr("&Quit"), QKeySequence("Ctrl+Q"), [this] { window_.close(); });
}

void WindowMenus::addEditMenu() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Edit"));
  QUndoGroup& history = subjects_.controller.history();
  QAction* undo = history.createUndoAction(&window_, tr("&Undo"));
  undo->setShortcut(QKeySequence("Ctrl+Z"));
  QAction* redo = history.createRedoAction(&window_, tr("&Redo"));
  redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  menu->addActions({undo, redo});
  menu->addSeparator();
  addAction(*menu, tr("&Copy plot"), QKeySequence::Copy,
            [this] { subjects_.evidence.currentPlot().copy(); });
  addAction(*menu, tr("Copy &table"), QKeySequence("Ctrl+Shift+C"),
            [this] { subjects_.evidence.table().copy(); });
}

void WindowMenus::addProbeMenu() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Probe"));
  addAction(*menu, tr("&Let go"), QKeySequence(Qt::Key_Escape),
            [this] { subjects_.prober.unpin(); });
  addAction(*menu, tr("Go to the &worst light bleeding"), QKeySequence("B"),
            [this] { subjects_.prober.pinWorstBleeding(); });
  addAction(*menu, tr("&Save this probe"), QKeySequence("K"), [this] { subjects_.saved.save(); });
  addAction(*menu, tr("Back to the &surface's own depth"), QKeySequence("R"), [this] {
    subjects_.controller.edit(tr("Reset receiver depth"),
                              [](Session& session) { session.receiver.reset(); });
  });
}

void WindowMenus::addWindowMenu() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Window"));
  for (QDockWidget* dock : subjects_.docks.all()) menu->addAction(dock->toggleViewAction());
  menu->addSeparator();
  addAction(*menu, tr("&Reset layout"), {}, [this] { subjects_.docks.reset(); });
}

}  // namespace umbra
