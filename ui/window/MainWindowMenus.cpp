// The window's menus, its tool bar and their keys.
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <QWidgetAction>

#include "datasets/scenes/SceneCatalogue.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/KeptProbes.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/TechniqueList.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/window/HelpDialogs.h"
#include "ui/window/LightForm.h"
#include "ui/window/MainWindow.h"
#include "ui/window/SceneForm.h"

namespace umbra {
namespace {

struct Mode {
  ViewMode mode;
  const char* text;
  int key;
};
constexpr Mode viewModes[] = {
    {ViewMode::Shaded, "Shaded", Qt::Key_F2},      {ViewMode::Visibility, "Visibility", Qt::Key_F3},
    {ViewMode::Error, "Signed error", Qt::Key_F4}, {ViewMode::Depth, "Depth", Qt::Key_F5},
    {ViewMode::Layers, "Layers", Qt::Key_F6},      {ViewMode::Cascades, "Cascades", Qt::Key_F7}};

const char* const meshFilter = "*.obj *.ply *.off *.stl";

}  // namespace

QAction* MainWindow::addAction(QMenu& menu, const QString& text, const QKeySequence& key,
                               const std::function<void()>& run) {
  QAction* action = menu.addAction(text);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, run);
  return action;
}

void MainWindow::makeActions() {
  sceneMenu_ = makeSceneMenu();
  exportMenu_ = makeExportMenu();
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeTechniqueMenu();
  makeProbeMenu();
  makeLessonsMenu();
  makeWindowMenu();
  makeHelpMenu();
  makeToolBar();
}

QMenu* MainWindow::makeSceneMenu() {
  auto* menu = new QMenu(tr("&Scene"), this);
  menu->setToolTipsVisible(true);
  for (const SceneInfo& info : sceneCatalogue()) {
    QAction* action = menu->addAction(style::text(info.title));
    const QString about = style::text(info.description + "\n" + info.figure).trimmed();
    action->setToolTip(info.missing.empty() ? about : style::text(info.missing));
    action->setEnabled(info.missing.empty());
    connect(action, &QAction::triggered, this, [this, name = info.name] {
      SceneSource source;
      source.name = name;
      controller_.openSource(source);
    });
  }
  menu->addSeparator();
  menu->addAction(tr("Open mesh …"), this,
                  [this] { askToOpen(tr("Open mesh"), tr("Meshes (%1)").arg(meshFilter)); });
  menu->addAction(tr("Open depth map …"), this,
                  [this] { askToOpen(tr("Open depth map"), tr("OpenEXR depth map (*.exr)")); });
  menu->addAction(tr("Open session …"), this,
                  [this] { askToOpen(tr("Open session"), tr("Session (*.json)")); });
  return menu;
}

QMenu* MainWindow::makeExportMenu() {
  auto* menu = new QMenu(tr("&Export"), this);
  addAction(*menu, tr("Picture …"), QKeySequence("Ctrl+E"), [this] { askToSavePicture(); });
  addAction(*menu, tr("Bleeding on the mesh …"), {}, [this] { askToExportBleeding(); });
  menu->addSeparator();
  addAction(*menu, tr("Visibility plot …"), {}, [this] { evidence_->curves().saveAs(); });
  addAction(*menu, tr("Depths plot …"), {}, [this] { evidence_->histogram().saveAs(); });
  addAction(*menu, tr("Distribution plot …"), {}, [this] { evidence_->cdf().saveAs(); });
  addAction(*menu, tr("Table of techniques …"), {}, [this] { askToSaveTable(); });
  addAction(*menu, tr("Table of kept probes …"), {}, [this] { askToSaveKeptProbes(); });
  menu->addSeparator();
  addAction(*menu, tr("Session …"), {}, [this] { askToSaveSession(); });
  return menu;
}

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  menu->addMenu(sceneMenu_);
  addAction(*menu, tr("&Open …"), QKeySequence::Open, [this] {
    askToOpen(tr("Open"), tr("All that can be opened (%1 *.exr *.json)").arg(meshFilter));
  });
  addAction(*menu, tr("&Save session …"), QKeySequence::Save, [this] { askToSaveSession(); });
  menu->addMenu(exportMenu_);
  menu->addSeparator();
  addAction(*menu, tr("&Quit"), QKeySequence("Ctrl+Q"), [this] { close(); });
}

void MainWindow::makeEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = controller_.history().createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence("Ctrl+Z"));
  QAction* redo = controller_.history().createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  menu->addActions({undo, redo});
  menu->addSeparator();
  addAction(*menu, tr("&Copy plot"), QKeySequence::Copy,
            [this] { evidence_->currentPlot().copy(); });
  addAction(*menu, tr("Copy &table"), QKeySequence("Ctrl+Shift+C"),
            [this] { evidence_->table().copy(); });
}

void MainWindow::makeViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  for (const Mode& mode : viewModes) {
    QAction* action = addAction(*menu, tr(mode.text), QKeySequence(mode.key), [this, mode] {
      controller_.edit(tr("View %1").arg(tr(mode.text).toLower()),
                       [&](Session& session) { session.frame.view = mode.mode; });
    });
    action->setCheckable(true);
    action->setData(int(mode.mode));
    modes_->addAction(action);
  }
  makeCompareMenu(*menu);
  menu->addSeparator();
  addAction(*menu, tr("The scene's &camera"), QKeySequence("Home"), [this] {
    controller_.edit(tr("Reset camera"), [](Session& session) { session.camera.reset(); });
  });
  addAction(*menu, tr("The scene's &light"), QKeySequence("Shift+Home"), [this] {
    controller_.edit(tr("Reset light"), [](Session& session) { session.light.reset(); });
  });
}

void MainWindow::makeTechniqueMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Technique"));
  menu->setToolTipsVisible(true);
  int place = 0;
  for (const Technique* technique : controller_.catalogue().all()) {
    const std::string id(technique->info().id);
    const QKeySequence key(techniqueKey(place));
    QAction* action = addAction(*menu, style::text(technique->info().title), key, [this, id] {
      controller_.edit(tr("Choose technique"),
                       [&](Session& session) { chooseTechnique(session, id); });
    });
    action->setCheckable(true);
    action->setData(style::text(id));
    techniques_->addAction(action);
    ++place;
  }
  menu->addSeparator();
  addAction(*menu, tr("Reset its &parameters"), {}, [this] {
    controller_.edit(tr("Reset parameters"),
                     [](Session& session) { session.parameters.erase(session.technique); });
  });
}

void MainWindow::makeProbeMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Probe"));
  addAction(*menu, tr("&Let go"), QKeySequence(Qt::Key_Escape), [this] { prober_->unpin(); });
  addAction(*menu, tr("Go to the &worst light bleeding"), QKeySequence("B"),
            [this] { prober_->pinWorstBleeding(); });
  addAction(*menu, tr("&Keep this probe"), QKeySequence("K"), [this] { kept_->keep(); });
  addAction(*menu, tr("Back to the &surface's own depth"), QKeySequence("R"), [this] {
    controller_.edit(tr("Reset receiver depth"),
                     [](Session& session) { session.receiver.reset(); });
  });
}

void MainWindow::makeWindowMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Window"));
  for (QDockWidget* dock : docks_) menu->addAction(dock->toggleViewAction());
  menu->addSeparator();
  addAction(*menu, tr("&Reset layout"), {}, [this] { resetLayout(); });
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  addAction(*menu, tr("This &technique"), QKeySequence::HelpContents,
            [this] { showTechniquePage(controller_.technique(), this); });
  addAction(*menu, tr("&Keyboard and mouse"), {}, [this] {
    std::vector<std::pair<QString, QString>> keys{
        {tr("Probe the point under the pointer"), tr("move")},
        {tr("Hold the probe at a point"), tr("click")},
        {tr("Turn the camera"), tr("left drag")},
        {tr("Move the camera"), tr("middle drag, Shift + left drag")},
        {tr("Nearer, farther"), tr("wheel, right drag")},
        {tr("Move the light"), tr("drag the sun")},
        {tr("Study another receiver depth"), tr("drag the amber line in a plot")}};
    for (const QAction* action : findChildren<QAction*>())
      if (!action->shortcut().isEmpty())
        keys.emplace_back(action->text().remove('&').remove(QStringLiteral(" …")),
                          action->shortcut().toString(QKeySequence::NativeText));
    showShortcuts(keys, this);
  });
  addAction(*menu, tr("&About Umbrascope"), {}, [this] { showAbout(this); });
}

void MainWindow::makeToolBar() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName("tools");
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  const auto menuButton = [&](const QString& text, QMenu* menu) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    bar->addWidget(button);
    return button;
  };
  sceneButton_ = menuButton(tr("Scene"), sceneMenu_);
  const auto formMenu = [this](QWidget* form) {
    auto* menu = new QMenu(this);
    auto* action = new QWidgetAction(menu);
    action->setDefaultWidget(form);
    menu->addAction(action);
    return menu;
  };
  sceneForm_ = new SceneForm(controller_);
  adjustButton_ = menuButton(tr("Adjust"), formMenu(sceneForm_));
  menuButton(tr("Light"), formMenu(new LightForm(controller_)));
  bar->addWidget(new QLabel(tr("View")));
  bar->addActions(modes_->actions());
  menuButton(tr("Compare"), findChild<QMenu*>("compare"));
  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  menuButton(tr("Export …"), exportMenu_);
}

}  // namespace umbra
