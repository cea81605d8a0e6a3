// One more plot of the probe, chosen from a list.
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <thread>

#include "analysis/plots/ExplainingPlots.h"
#include "ui/picture/ProbeReport.h"

class QComboBox;

namespace umbra {

class PlotPane;
class Prober;
class SessionController;

// Shows the chosen plot while it is watched and computes none otherwise. One that takes long is
// computed beside the interface's thread once the probe stands still.
class ExplainPane : public QWidget {
  Q_OBJECT

 public:
  ExplainPane(SessionController& controller, Prober& prober, QWidget* parent = nullptr);
  // Waits for the step that is being computed.
  ~ExplainPane() override;

  PlotPane& plot() { return *plot_; }
  void setWatched(bool watched);

 private:
  void refresh();
  void computeBeside();
  void finished(int number, const std::optional<Plot>& plot);
  void show(const std::optional<Plot>& plot);
  ExplainingInput inputFor(const ProbeRequest& request, const Probe& probe) const;
  const ExplainingPlot& chosen() const;

  SessionController& controller_;
  Prober& prober_;
  QComboBox* chooser_;
  PlotPane* plot_;
  bool watched_ = false;
  QTimer still_;   // the probe has not moved since
  int asked_ = 0;  // number of the computation that is wanted
  std::jthread thread_;
};

}  // namespace umbra
