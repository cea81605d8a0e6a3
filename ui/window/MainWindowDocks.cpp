// The window's docks: where they stand at first, and again after "Reset layout".
#include <QDockWidget>
#include <QHBoxLayout>
#include <QStatusBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/errors/ErrorController.h"
#include "ui/errors/ErrorPane.h"
#include "ui/layers/LayersController.h"
#include "ui/layers/LayersPane.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/ExplainPane.h"
#include "ui/probe/KeptProbesPane.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/widgets/tables/RegionTable.h"
#include "ui/widgets/tables/TracePane.h"
#include "ui/window/ControlPane.h"
#include "ui/window/DockGrip.h"
#include "ui/window/MainWindow.h"

namespace umbra {
namespace {

// Below this height (logical pixels) the plots share one place as tabs.
constexpr int tallWindow = 840;

// Map and statistics side by side, as they are read together.
QWidget* makeMapPane(ShadowMapView& map, RegionTable& region) {
  auto* pane = new QWidget;
  auto* layout = new QHBoxLayout(pane);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(&map, 5);
  layout->addWidget(&region, 3);
  return pane;
}

}  // namespace

void MainWindow::makeDocks() {
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCorner(Qt::TopLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::TopRightCorner, Qt::RightDockWidgetArea);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  addDock(tr("Controls"), "controlsDock", controls_, Qt::LeftDockWidgetArea);
  addDock(tr("All techniques"), "tableDock", &evidence_->table(), Qt::BottomDockWidgetArea);
  addDock(tr("Shadow map"), "mapDock", makeMapPane(evidence_->map(), evidence_->region()),
          Qt::RightDockWidgetArea);
  addDock(tr("Visibility"), "curvesDock", &evidence_->curves(), Qt::RightDockWidgetArea);
  addDock(tr("Depths"), "histogramDock", &evidence_->histogram(), Qt::RightDockWidgetArea);
  addDock(tr("Distribution"), "cdfDock", &evidence_->cdf(), Qt::RightDockWidgetArea);
  // One above the other they would make the smallest window taller than a projector.
  tabifyDockWidget(docks_[3], docks_[4]);
  tabifyDockWidget(docks_[3], docks_[5]);
  addDock(tr("Why is it lit?"), "traceDock", &evidence_->trace(), Qt::BottomDockWidgetArea);
  tabifyDockWidget(docks_[1], docks_.back());
  addDock(tr("Probes"), "probesDock", keptPane_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(docks_[1], docks_.back());
  makeWatchedDocks();
}

// What costs work while it is watched. A dock behind another's tab is shown, to itself: only
// visibilityChanged tells.
void MainWindow::makeWatchedDocks() {
  auto* layers = new LayersController(controller_, *view_, this);
  auto* layersPane = new LayersPane(*layers, controller_);
  connect(layers, &LayersController::failed, this, &MainWindow::showError);
  connect(layersPane, &LayersPane::message, this,
          [this](const QString& text) { statusBar()->showMessage(text, 6000); });
  connect(addDock(tr("Layers"), "layersDock", layersPane, Qt::RightDockWidgetArea),
          &QDockWidget::visibilityChanged, layers, &LayersController::setWatched);
  tabifyDockWidget(docks_[3], docks_.back());

  auto* explain = new ExplainPane(controller_, *prober_);
  evidence_->follow(explain->plot());
  connect(addDock(tr("More plots"), "explainDock", explain, Qt::RightDockWidgetArea),
          &QDockWidget::visibilityChanged, explain, &ExplainPane::setWatched);
  tabifyDockWidget(docks_[3], docks_.back());

  auto* errors = new ErrorController(controller_, *view_, *prober_, this);
  connect(errors, &ErrorController::failed, this, &MainWindow::showError);
  connect(
      addDock(tr("Error"), "errorDock", new ErrorPane(*errors, *prober_), Qt::RightDockWidgetArea),
      &QDockWidget::visibilityChanged, errors, &ErrorController::setWatched);
  tabifyDockWidget(docks_[3], docks_.back());
}

QDockWidget* MainWindow::addDock(const QString& title, const QString& name, QWidget* content,
                                 Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setTitleBarWidget(new DockGrip);
  auto* room = new QWidget;  // air on every side: a window's docks reach to its edge
  auto* layout = new QVBoxLayout(room);
  layout->setContentsMargins(5, 0, 5, 5);
  layout->addWidget(content);
  dock->setWidget(room);
  addDockWidget(area, dock);
  docks_.push_back(dock);
  return dock;
}

void MainWindow::resetLayout() {
  const auto dockOf = [this](const char* name) { return findChild<QDockWidget*>(name); };
  QDockWidget *controls = dockOf("controlsDock"), *table = dockOf("tableDock"),
              *map = dockOf("mapDock"), *curves = dockOf("curvesDock"),
              *histogram = dockOf("histogramDock"), *cdf = dockOf("cdfDock"),
              *trace = dockOf("traceDock"), *layers = dockOf("layersDock"),
              *explain = dockOf("explainDock"), *probes = dockOf("probesDock"),
              *error = dockOf("errorDock");
  for (QDockWidget* dock : docks_) dock->setFloating(false);
  for (QDockWidget* dock : docks_) removeDockWidget(dock);
  addDockWidget(Qt::LeftDockWidgetArea, controls);
  addDockWidget(Qt::BottomDockWidgetArea, table);
  addDockWidget(Qt::RightDockWidgetArea, map);
  splitDockWidget(map, curves, Qt::Vertical);
  const bool tall = height() >= tallWindow;
  if (tall)
    splitDockWidget(curves, histogram, Qt::Vertical);
  else
    tabifyDockWidget(curves, histogram);
  tabifyDockWidget(histogram, cdf);
  tabifyDockWidget(cdf, layers);
  tabifyDockWidget(layers, explain);
  tabifyDockWidget(curves, error);  // on top of the tallest: it is a picture
  tabifyDockWidget(table, trace);
  tabifyDockWidget(trace, probes);
  for (QDockWidget* dock : docks_) dock->show();
  curves->raise();
  if (tall) histogram->raise();
  table->raise();

  const int side = width() < 1500 ? 268 : 290, right = width() * 35 / 100;
  resizeDocks({controls, map}, {side, right}, Qt::Horizontal);
  resizeDocks({table}, {tall ? 335 : 215}, Qt::Vertical);
  const int rest = height() - 110;
  if (tall)
    resizeDocks({map, curves, histogram}, {rest * 29 / 100, rest * 41 / 100, rest * 30 / 100},
                Qt::Vertical);
  else
    resizeDocks({map, curves}, {rest * 42 / 100, rest * 58 / 100}, Qt::Vertical);
  placeLessonDock();
}

}  // namespace umbra
