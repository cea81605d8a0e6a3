// The panes that show why the probed pixel is as bright as it is.
#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <vector>

#include "filters/core/maps/Image.h"
#include "filters/core/settings/Kernel.h"

namespace umbra {

class PlotPane;
class ProbeTable;
class Prober;
class RayTracedTruth;
class RegionTable;
class SceneView;
class SessionController;
class ShadowMapView;
class TracePane;

// Makes the panes and keeps them in step with probe and session. The window puts them into docks,
// which then own them.
class EvidencePanes : public QObject {
  Q_OBJECT

 public:
  EvidencePanes(SessionController& controller, SceneView& view, Prober& prober,
                QObject* parent = nullptr);

  ShadowMapView& map() { return *map_; }
  RegionTable& region() { return *region_; }
  PlotPane& curves() { return *curves_; }
  PlotPane& cdf() { return *cdf_; }
  PlotPane& histogram() { return *histogram_; }
  ProbeTable& table() { return *table_; }
  TracePane& trace() { return *trace_; }
  // All plots; and the one under the pointer or last used, the curves before that.
  std::vector<PlotPane*> plots() { return {curves_, cdf_, histogram_}; }
  PlotPane& currentPlot();
  // A plot of another pane, of this probe: its receiver is dragged, its messages are shown, and it
  // may be the current one. It must live as long as the window.
  void follow(PlotPane& plot);

  // After a frame or a new document: the map, where it changed.
  void refreshMap();

 signals:
  void message(const QString& text);
  void failed(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refreshProbe();
  void refreshTable();
  void showHints();
  void showChannel();
  QStringList channelNames() const;
  void dragReceiver(double depth);

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  RayTracedTruth* rays_;  // hears of a probe before the panes do
  ShadowMapView* map_;
  RegionTable* region_;
  PlotPane *curves_, *cdf_, *histogram_;
  PlotPane* lastPlot_;
  ProbeTable* table_;
  TracePane* trace_;
  // Which channel of which map is shown, to read back only what changed.
  QString shownChannel_;
  std::shared_ptr<const void> shownMap_;
  int shownCascade_ = 0;
  bool regionShown_ = false;
  Kernel shownKernel_;
};

}  // namespace umbra
