// One series of a plot. Qwt's own curve classes do not compile as C++20 (a template-id names the
// destructor in qwt_series_store.h of 6.1), and this is all that we need of them.
#pragma once

#include <qwt_plot_item.h>

#include <QPolygonF>

#include "analysis/plots/Plot.h"

namespace umbra {

class SeriesItem final : public QwtPlotItem {
 public:
  explicit SeriesItem(const PlotSeries& series);

  void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
            const QRectF& canvas) const override;
  QRectF boundingRect() const override;
  QwtGraphic legendIcon(int index, const QSizeF& size) const override;

 private:
  QPen pen() const;
  // In the painter's pixels; steps have a corner before every new value.
  QPolygonF outline(const QwtScaleMap& xMap, const QwtScaleMap& yMap) const;
  void drawBars(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                const QRectF& canvas) const;

  PlotSeries series_;
  QColor colour_;
};

}  // namespace umbra
