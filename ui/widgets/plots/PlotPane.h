// One plot in a card, with what a person may do with it: read values, copy, save, drag z_r.
#pragma once

#include <filesystem>
#include <optional>

#include "analysis/plots/Plot.h"
#include "ui/widgets/base/Card.h"

class QLabel;
class QStackedLayout;
class QwtPlot;

namespace umbra {

class PlotPane : public Card {
  Q_OBJECT

 public:
  explicit PlotPane(const QString& title = {}, QWidget* parent = nullptr);

  // The card's title becomes the plot's.
  void setPlot(const Plot& plot);
  // No plot: `hint` says how to get one.
  void clear(const QString& hint);
  const std::optional<Plot>& plot() const { return plot_; }
  QwtPlot* canvas() { return widget_; }

  // Writes what the file's extension says: .svg, .pdf, .png or .csv. Throws BadOutput;
  // BadCommandLine for another extension.
  void save(const std::filesystem::path& file) const;

 public slots:
  void copy() const;  // the picture to the clipboard
  void saveAs();      // asks for the file

 signals:
  // The receiver's marker (a vertical one in probeColour) is dragged to this x, in [0,1]; or the
  // pointer is dragged along the axis beneath such a plot.
  void depthDragged(double depth);
  void depthDragFinished();
  // A draggable marker, counted in the plot's list, is dragged to this x, in [0,1].
  void markerDragged(int marker, double x);
  void markerDragFinished();
  // Says in one line for the status bar, after saveAs, that the file is written, or why it is not.
  void message(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  // The marker nearest to this pixel across the plot's canvas, of those that can be dragged there.
  std::optional<int> markerAt(int pixel) const;
  bool isReceiver(int marker) const;
  std::optional<int> receiver() const;  // the marker that is one, if it can be dragged
  bool canvasEvent(QEvent* event);
  bool axisEvent(QEvent* event);
  void drag(int pixel);
  void endDrag();
  double depthAt(int pixel) const;
  void fitAxisTitle();  // cut where the plot is narrow
  void hover(const QPoint& pixel);

  QwtPlot* widget_;
  QLabel* hint_;
  QStackedLayout* pages_;
  std::optional<Plot> plot_;
  std::optional<int> dragged_;  // marker
};

}  // namespace umbra
