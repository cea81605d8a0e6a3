// A stretch of x behind the grid and the series of a plot.
#pragma once

#include <qwt_plot_item.h>

#include "analysis/plots/Plot.h"

namespace umbra {

class BandItem final : public QwtPlotItem {
 public:
  explicit BandItem(const PlotBand& band);

  void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
            const QRectF& canvas) const override;

 private:
  void hatch(QPainter* painter, const QRectF& place) const;

  PlotBand band_;
};

}  // namespace umbra
