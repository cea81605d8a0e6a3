// Markers and error bars of a plot with their labels, drawn over its curves.
#pragma once

#include <qwt_plot_item.h>
#include <qwt_text.h>

#include "analysis/plots/Plot.h"
#include "ui/plots/LabelPlacer.h"

namespace umbra {

class AnnotationItem final : public QwtPlotItem {
 public:
  explicit AnnotationItem(const Plot& plot);

  void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
            const QRectF& canvas) const override;

 private:
  struct Frame;  // what one drawing shares

  void avoidSeries(Frame& frame) const;
  void drawMarkerLine(Frame& frame, const PlotMarker& marker) const;
  void drawErrorBar(Frame& frame, const PlotError& error) const;
  void drawMarkerLabel(Frame& frame, const PlotMarker& marker) const;
  void drawErrorLabel(Frame& frame, const PlotError& error) const;

  Plot plot_;
};

}  // namespace umbra
