// Keeps a plot's ticks, titles and legend fitting while its widget changes size.
#pragma once

#include <QObject>

#include "analysis/plots/Plot.h"

class QwtPlot;

namespace umbra {

// Lives as a child of the plot's widget; `of` makes it once. The legend goes outside the curves,
// beside or below them, wherever they keep more room. Its place depends on the widget's size alone,
// so that it does not jump while the curves change. Where it would leave the curves no room there
// is no legend, since a technique has the same colour in the tables beside the plot; titles that
// find no room are shortened or left out.
class PlotFitter final : public QObject {
 public:
  static PlotFitter& of(QwtPlot& widget);

  // From now on the widget's axes, titles and legend are those of `plot`.
  void setPlot(const Plot& plot);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  explicit PlotFitter(QwtPlot& widget);
  void fit();
  void fitLegend();
  void fitTitles();
  void fitScales();
  double wholeStep() const;

  QwtPlot& widget_;
  Plot plot_;
};

}  // namespace umbra
