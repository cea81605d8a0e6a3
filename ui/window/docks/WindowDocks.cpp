#include "ui/window/docks/WindowDocks.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/probe/EvidencePanes.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/widgets/tables/RegionTable.h"
#include "ui/widgets/tables/TracePane.h"
#include "ui/window/docks/DockGrip.h"
#include "ui/window/docks/WatchedPanes.h"

namespace umbra {
namespace {

// Below this height (logical pixels) the plots share one place as tabs.
constexpr int tallWindow = 840;

// Map and statistics stand side by side, as they are read together.
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

WindowDocks::WindowDocks(QMainWindow& window, QWidget& controls, EvidencePanes& evidence,
                         QWidget& savedProbes, WatchedPanes& watched)
    : QObject(&window), window_(window) {
  window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  window.setCorner(Qt::TopLeftCorner, Qt::LeftDockWidgetArea);
  window.setCorner(Qt::TopRightCorner, Qt::RightDockWidgetArea);
  window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  constexpr auto left = Qt::LeftDockWidgetArea, right = Qt::RightDockWidgetArea,
                 bottom = Qt::BottomDockWidgetArea;
  controls_ = add(tr("Controls"), "controlsDock", controls, left);
  table_ = add(tr("All techniques"), "tableDock", evidence.table(), bottom);
  map_ = add(tr("Shadow map"), "mapDock", *makeMapPane(evidence.map(), evidence.region()), right);
  curves_ = add(tr("Visibility"), "curvesDock", evidence.curves(), right);
  histogram_ = add(tr("Depths"), "histogramDock", evidence.histogram(), right);
  cdf_ = add(tr("Distribution"), "cdfDock", evidence.cdf(), right);
  // One above the other they would make the smallest window taller than a projector.
  for (QDockWidget* dock : {histogram_, cdf_}) window.tabifyDockWidget(curves_, dock);
  trace_ = add(tr("Why is it lit?"), "traceDock", evidence.trace(), bottom);
  window.tabifyDockWidget(table_, trace_);
  probes_ = add(tr("Probes"), "probesDock", savedProbes, bottom);
  window.tabifyDockWidget(table_, probes_);
  layers_ = add(tr("Layers"), "layersDock", watched.layers(), right);
  window.tabifyDockWidget(curves_, layers_);
  explain_ = add(tr("More plots"), "explainDock", watched.explain(), right);
  window.tabifyDockWidget(curves_, explain_);
  error_ = add(tr("Error"), "errorDock", watched.error(), right);
  window.tabifyDockWidget(curves_, error_);
  watched.follow(*layers_, *explain_, *error_);
}

QDockWidget* WindowDocks::makeDock(const QString& title, const QString& name, QWidget& content,
                                   Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(name);
  dock->setTitleBarWidget(new DockGrip);
  auto* room = new QWidget;  // air on every side: a window's docks reach to its edge
  auto* layout = new QVBoxLayout(room);
  layout->setContentsMargins(5, 0, 5, 5);
  layout->addWidget(&content);
  dock->setWidget(room);
  window_.addDockWidget(area, dock);
  return dock;
}

QDockWidget* WindowDocks::add(const QString& title, const QString& name, QWidget& content,
                              Qt::DockWidgetArea area) {
  docks_.push_back(makeDock(title, name, content, area));
  return docks_.back();
}

void WindowDocks::reset() {
  for (QDockWidget* dock : docks_) dock->setFloating(false);
  for (QDockWidget* dock : docks_) window_.removeDockWidget(dock);
  const bool tall = window_.height() >= tallWindow;
  place(tall);
  for (QDockWidget* dock : docks_) dock->show();
  curves_->raise();
  if (tall) histogram_->raise();
  table_->raise();
  resize(tall);
  emit arranged();
}

void WindowDocks::place(bool tall) {
  window_.addDockWidget(Qt::LeftDockWidgetArea, controls_);
  window_.addDockWidget(Qt::BottomDockWidgetArea, table_);
  window_.addDockWidget(Qt::RightDockWidgetArea, map_);
  window_.splitDockWidget(map_, curves_, Qt::Vertical);
  if (tall)
    window_.splitDockWidget(curves_, histogram_, Qt::Vertical);
  else
    window_.tabifyDockWidget(curves_, histogram_);
  window_.tabifyDockWidget(histogram_, cdf_);
  window_.tabifyDockWidget(cdf_, layers_);
  window_.tabifyDockWidget(layers_, explain_);
  window_.tabifyDockWidget(curves_, error_);  // on top of the tallest: it is a picture
  window_.tabifyDockWidget(table_, trace_);
  window_.tabifyDockWidget(trace_, probes_);
}

// In logical pixels, and in hundredths of the window.
void WindowDocks::resize(bool tall) {
  const int side = window_.width() < 1500 ? 268 : 290, right = window_.width() * 35 / 100;
  window_.resizeDocks({controls_, map_}, {side, right}, Qt::Horizontal);
  window_.resizeDocks({table_}, {tall ? 335 : 215}, Qt::Vertical);
  const int rest = window_.height() - 110;
  if (tall)
    window_.resizeDocks({map_, curves_, histogram_},
                        {rest * 29 / 100, rest * 41 / 100, rest * 30 / 100}, Qt::Vertical);
  else
    window_.resizeDocks({map_, curves_}, {rest * 42 / 100, rest * 58 / 100}, Qt::Vertical);
}

}  // namespace umbra
