// Keeps a plot's ticks and legend fitting while its widget changes size.
#pragma once

#include <QObject>

class QwtPlot;

namespace umbra {

// Lives as a child of the plot; `of` makes it once. The legend goes outside the curves, beside or
// below them, wherever they keep more room: a matter of size alone, so that it does not jump
// while the curves change.
class PlotFitter final : public QObject {
 public:
  static PlotFitter& of(QwtPlot& widget);

  void fit();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  explicit PlotFitter(QwtPlot& widget);

  QwtPlot& widget_;
};

}  // namespace umbra
