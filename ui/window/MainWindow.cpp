#include "ui/window/MainWindow.h"

#include <QCloseEvent>

#include "ui/lessons/LessonController.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/picture/ProbeMarks.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/probe/ReductionTools.h"
#include "ui/probe/SavedProbes.h"
#include "ui/probe/SavedProbesPane.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/CentrePane.h"
#include "ui/window/ControlPane.h"
#include "ui/window/MessageBanner.h"
#include "ui/window/SessionPresenter.h"
#include "ui/window/StatusLine.h"
#include "ui/window/docks/LessonVisit.h"
#include "ui/window/docks/WatchedPanes.h"
#include "ui/window/docks/WindowDocks.h"
#include "ui/window/files/BleedingExport.h"
#include "ui/window/files/FileActions.h"
#include "ui/window/files/FileDialogs.h"
#include "ui/window/files/FileDrop.h"
#include "ui/window/files/ImportSheet.h"
#include "ui/window/files/SavedSession.h"
#include "ui/window/files/TableExport.h"
#include "ui/window/menus/WindowMenus.h"
#include "ui/window/menus/WindowToolBar.h"

namespace umbra {

// The parts hear of a change in the order in which they are made here: the picture after the panes,
// the status line after the picture.
MainWindow::MainWindow(const Workspace& workspace, QWidget* parent)
    : QMainWindow(parent),
      controller_(workspace),
      view_(new SceneView),
      prober_(new Prober(controller_, *view_, this)),
      evidence_(new EvidencePanes(controller_, *view_, *prober_, this)),
      controls_(new ControlPane(controller_, *prober_, *view_)),
      centre_(new CentrePane(controller_, *view_, *prober_)),
      saved_(new SavedProbes(controller_, *view_, *prober_, this)),
      savedPane_(new SavedProbesPane(*saved_, controller_, *prober_)),
      lessons_(new LessonController(controller_, *prober_, this)) {
  setObjectName("umbrascope");
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setCentralWidget(centre_);
  makeDocks();
  makeFileActions();
  makeMenus();
  presenter_ = new SessionPresenter(controller_, *view_, *prober_, *evidence_, this);
  status_ = new StatusLine(*statusBar(), controller_, *view_);
  connectMessages();
  connect(&controller_, &SessionController::changed, this, &MainWindow::showTitle);
  connect(saved_, &SavedProbes::changed, this, [this] { view_->setMarks(saved_->marks()); });
  connect(files_, &FileActions::lessonOpened, visit_, &LessonVisit::enter);
  connect(visit_, &LessonVisit::left, presenter_, &SessionPresenter::keepProbe);
  showTitle();
  view_->setMarks(saved_->marks());
  presenter_->start();
}

// The panes are children of the window and outlive the controller, which is a member: they must not
// hear it any more.
MainWindow::~MainWindow() {
  disconnect(&controller_, nullptr, nullptr, nullptr);
}

void MainWindow::makeDocks() {
  watched_ = new WatchedPanes(controller_, *view_, *prober_, *evidence_, this);
  docks_ = new WindowDocks(*this, *controls_, *evidence_, *savedPane_, *watched_);
  visit_ = new LessonVisit(*this, *docks_, controller_, *view_, *prober_, *lessons_);
}

void MainWindow::makeFileActions() {
  dialogs_ = new FileDialogs(*this);
  files_ = new FileActions(*dialogs_, controller_, *view_, *prober_, centre_->comparison(), this);
  new FileDrop(*this, *files_);
  import_ = new ImportSheet(*this, controller_);
  tables_ = new TableExport(*dialogs_, *prober_, evidence_->table(), *savedPane_, this);
  bleeding_ = new BleedingExport(*this, *dialogs_, controller_, *view_, *prober_);
}

void MainWindow::makeMenus() {
  auto* menus =
      new WindowMenus(*this, {controller_, *prober_, *saved_, *evidence_, *files_, *import_,
                              *tables_, *bleeding_, *docks_, *lessons_, *visit_});
  addToolBar(new WindowToolBar(controller_, *menus, this));
}

void MainWindow::connectMessages() {
  MessageBanner* banner = &centre_->banner();
  const auto showErrorsOf = [banner](auto* part) {
    using Part = std::remove_pointer_t<decltype(part)>;
    connect(part, &Part::failed, banner, &MessageBanner::showError);
  };
  showErrorsOf(&controller_);
  showErrorsOf(view_);
  showErrorsOf(prober_);
  showErrorsOf(&centre_->comparison());
  showErrorsOf(&controls_->reduction());
  showErrorsOf(evidence_);
  showErrorsOf(watched_);
  showErrorsOf(dialogs_);
  showErrorsOf(files_);
  showErrorsOf(tables_);
  showErrorsOf(bleeding_);
  showErrorsOf(presenter_);
  connect(bleeding_, &BleedingExport::written, banner, &MessageBanner::showNotice);
  connect(import_, &ImportSheet::refused, banner, &MessageBanner::dismiss);
  const auto showMessagesOf = [this](auto* part) {
    using Part = std::remove_pointer_t<decltype(part)>;
    connect(part, &Part::message, status_, &StatusLine::showMessage);
  };
  showMessagesOf(evidence_);
  showMessagesOf(saved_);
  showMessagesOf(watched_);
  showMessagesOf(dialogs_);
  showMessagesOf(bleeding_);
}

void MainWindow::showTitle() {
  setWindowTitle(tr("%1 – Umbrascope").arg(style::text(titleOf(controller_.session().source))));
}

LessonPane& MainWindow::lessonPane() {
  return visit_->pane();
}

SurfaceExport& MainWindow::surfaces() {
  return bleeding_->work();
}

const std::vector<QDockWidget*>& MainWindow::docks() const {
  return docks_->all();
}

Workspace MainWindow::sessionToSave() const {
  return umbra::sessionToSave(controller_, *view_, *prober_);
}

Workspace MainWindow::sessionToRemember() const {
  return umbra::sessionToRemember(controller_, *view_, *prober_);
}

void MainWindow::openFile(const std::filesystem::path& file) {
  files_->open(file);
}

void MainWindow::saveSession(const std::filesystem::path& file) {
  files_->saveSession(file);
}

void MainWindow::savePicture(const std::filesystem::path& file) {
  files_->savePicture(file);
}

void MainWindow::exportBleeding(const std::filesystem::path& file) {
  bleeding_->start(file);
}

void MainWindow::enterLesson(const Lesson& lesson) {
  visit_->enter(lesson);
}

void MainWindow::leaveLesson() {
  visit_->leave();
}

void MainWindow::resetLayout() {
  docks_->reset();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (lessons_->progress()) visit_->restoreLayout();  // the next window begins without a lesson
  emit closing();
  QMainWindow::closeEvent(event);
}

}  // namespace umbra
