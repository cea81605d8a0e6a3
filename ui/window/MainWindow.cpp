#include "ui/window/MainWindow.h"

#include <QActionGroup>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QStatusBar>
#include <QToolButton>
#include <exception>

#include "ui/lessons/LessonController.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/picture/FrameFigures.h"
#include "ui/picture/ProbeMarks.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/KeptProbes.h"
#include "ui/probe/KeptProbesPane.h"
#include "ui/probe/Prober.h"
#include "ui/probe/ReductionTools.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/CentrePane.h"
#include "ui/window/ControlPane.h"
#include "ui/window/MessageBanner.h"
#include "ui/window/SceneForm.h"

namespace umbra {

MainWindow::MainWindow(const Session& session, QWidget* parent)
    : QMainWindow(parent),
      controller_(session),
      view_(new SceneView),
      prober_(new Prober(controller_, *view_, this)),
      evidence_(new EvidencePanes(controller_, *view_, *prober_, this)),
      controls_(new ControlPane(controller_, *prober_, *view_)),
      centre_(new CentrePane(controller_, *view_, *prober_)),
      kept_(new KeptProbes(controller_, *view_, *prober_, this)),
      keptPane_(new KeptProbesPane(*kept_, controller_, *prober_)),
      lessons_(new LessonController(controller_, *prober_, this)),
      modes_(new QActionGroup(this)),
      techniques_(new QActionGroup(this)),
      sceneText_(new QLabel),
      frameText_(new QLabel),
      mapText_(new QLabel) {
  setObjectName("umbrascope");
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setCentralWidget(centre_);
  makeDocks();
  makeLessonDock();
  makeSurfaceExport();
  makeActions();
  sceneText_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  statusBar()->addWidget(sceneText_, 1);
  for (QLabel* label : {frameText_, mapText_}) {
    label->setFont(style::figures(label->font()));
    statusBar()->addPermanentWidget(label);
  }
  connectParts();
  view_->showDocument(controller_.document(), controller_.technique());
  view_->setMarks(kept_->marks());
  refresh();
  showNotices();
  // No frame calls for the probe of a depth file; its panes have their sizes once this returned.
  if (controller_.document().content.depth)
    QMetaObject::invokeMethod(prober_, &Prober::refresh, Qt::QueuedConnection);
}

// The panes end before what they listen to.
MainWindow::~MainWindow() {
  disconnect(&controller_, nullptr, nullptr, nullptr);
}

void MainWindow::connectParts() {
  connect(&controller_, &SessionController::changed, this,
          [this](const Document& before, const Document& after) {
            if (!(before.content == after.content)) {
              showNotices();
              probeNextFrame_ = after.content.scene != nullptr;
            }
            attempt([&] { view_->showDocument(after, controller_.technique()); });
            if (!view_->stale()) probeNextFrame_ = false;  // no frame follows
            // What needs a frame waits for the one that follows.
            if (after.content.depth || view_->upToDate()) evidence_->refreshMap();
            refresh();
            if (view_->upToDate()) prober_->refresh();
          });
  connect(&controller_, &SessionController::loadingChanged, this, [this](bool loading) {
    if (loading) centre_->banner().showProgress(tr("Opening …"));
  });
  connect(&controller_, &SessionController::failed, this, &MainWindow::showError);
  connect(view_, &SceneView::failed, this, &MainWindow::showError);
  connect(prober_, &Prober::failed, this, &MainWindow::showError);
  connect(&centre_->comparison(), &ComparisonPanes::failed, this, &MainWindow::showError);
  connect(&controls_->reduction(), &ReductionTools::failed, this, &MainWindow::showError);
  connect(evidence_, &EvidencePanes::failed, this, &MainWindow::showError);
  connect(evidence_, &EvidencePanes::message, statusBar(),
          [this](const QString& text) { statusBar()->showMessage(text, 6000); });
  connect(kept_, &KeptProbes::changed, this, [this] { view_->setMarks(kept_->marks()); });
  connect(kept_, &KeptProbes::message, statusBar(),
          [this](const QString& text) { statusBar()->showMessage(text, 6000); });
  connect(view_, &SceneView::frameDrawn, this, &MainWindow::afterFrame);
  connect(view_, &SceneView::cameraMoved, this, [this](const Camera& camera) {
    controller_.edit(
        tr("Move camera"), [&](Session& s) { s.camera = camera; }, "camera");
  });
  connect(view_, &SceneView::lightDragged, this, [this](const Light& light) {
    controller_.edit(
        tr("Move light"), [&](Session& s) { s.light = light; }, "light");
  });
  connect(view_, &SceneView::lightDragFinished, this, [this] { controller_.endMerge(); });
}

void MainWindow::afterFrame() {
  showFrameFigures();
  if (!probeNextFrame_ || view_->stale()) return;
  probeNextFrame_ = false;
  // A newcomer sees at once what the program is for.
  if (!controller_.session().probe) prober_->startAtWorstBleeding();
}

void MainWindow::refresh() {
  const Session& session = controller_.session();
  const QString title = QString::fromStdString(titleOf(session.source));
  setWindowTitle(tr("%1 – Umbrascope").arg(title));
  sceneButton_->setText(tr("Scene: %1")
                            .arg(session.source.kind == SourceKind::Catalogue
                                     ? style::text(session.source.name)
                                     : title));
  adjustButton_->setEnabled(sceneForm_->adjustable());
  const Scene* scene = controller_.document().content.scene.get();
  const bool onScene = scene != nullptr;
  // What a storage format does to a parameter matters more than where one is.
  const bool figure = onScene && !scene->figure.empty();
  sceneText_->setText(!controller_.notices().isEmpty() ? controller_.notices().join("  ")
                      : figure ? title + QStringLiteral(" · ") + style::text(scene->figure)
                               : title);
  for (QAction* action : modes_->actions()) {
    action->setChecked(action->data().toInt() == int(session.frame.view));
    action->setEnabled(onScene);
  }
  const QMap<QString, QString> refusals = controller_.refusals();
  for (QAction* action : techniques_->actions()) {
    const bool current = action->data().toString() == style::text(session.technique);
    const QString refusal = refusals.value(action->data().toString());
    action->setChecked(current);
    action->setEnabled(current || refusal.isEmpty());
    action->setToolTip(refusal);
  }
  refreshCompareMenu();
  showFrameFigures();
}

void MainWindow::showFrameFigures() {
  const Session& session = controller_.session();
  if (const DepthMap* depth = controller_.document().content.depth.get()) {
    frameText_->clear();
    mapText_->setText(tr("%1 × %2 texels").arg(depth->width()).arg(depth->height()));
    return;
  }
  const auto times = view_->lastFrame() ? view_->lastFrame()->passTimes() : std::vector<PassTime>{};
  frameText_->setText(passTimesText(times));
  mapText_->setText(mapText(session.frame, controller_.technique()));
}

// Of what was opened: what its file had that is not shown.
void MainWindow::showNotices() {
  QStringList lines;
  for (const std::string& notice : controller_.document().content.notices)
    lines << style::text(notice);
  if (lines.isEmpty())
    centre_->banner().dismiss();
  else
    centre_->banner().showNotice(lines.join("\n"));
}

void MainWindow::showError(const QString& text) {
  centre_->banner().showError(text);
}

Session MainWindow::sessionToSave() const {
  Session session = controller_.session();
  if (!controller_.document().content.scene) return session;
  const QSize size = view_->pixels();
  const auto& report = prober_->behindVeil();
  if (size.isEmpty()) return session;
  // The report may be of a picture of another size still.
  if (session.probe && report && report->pinned && report->point)
    session.probe = view_->pixelOf(*report->point).value_or(report->pixel);
  if (!session.probe || (report && report->pinned)) {
    session.width = size.width();
    session.height = size.height();
  }
  return session;
}

Session MainWindow::sessionToRemember() const {
  return controller_.visiting() ? controller_.ownSession() : sessionToSave();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (lessons_->progress()) restoreOwnLayout();  // the next window begins without a lesson
  emit closing();
  QMainWindow::closeEvent(event);
}

}  // namespace umbra
