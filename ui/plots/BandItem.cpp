#include "ui/plots/BandItem.h"

#include <qwt_scale_map.h>

#include <QPainter>
#include <QPainterPath>

namespace umbra {
namespace {

constexpr double fillShare = 0.45;   // opacity: the grid and the bars stay readable
constexpr double hatchShare = 0.45;  // opacity of the hatching's lines
constexpr double hatchStep = 5.0;    // pixels

}  // namespace

BandItem::BandItem(const PlotBand& band) : band_(band) {
  setZ(1.0);
  setItemAttribute(QwtPlotItem::Legend, false);
  setRenderHint(QwtPlotItem::RenderAntialiased);
}

void BandItem::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap&,
                    const QRectF& canvas) const {
  const double from = xMap.transform(band_.low), to = xMap.transform(band_.high);
  const QRectF place = QRectF(from, canvas.top(), to - from, canvas.height()) & canvas;
  if (place.isEmpty()) return;
  QColor colour(QString::fromStdString(band_.colour));
  if (band_.hatched) return hatch(painter, place);
  colour.setAlphaF(fillShare);
  painter->fillRect(place, colour);
}

// Draws single lines in place of a pattern brush, since files keep these as lines.
void BandItem::hatch(QPainter* painter, const QRectF& place) const {
  QColor colour(QString::fromStdString(band_.colour));
  colour.setAlphaF(hatchShare);
  QPainterPath lines;
  for (double x = place.left() - place.height(); x < place.right(); x += hatchStep) {
    lines.moveTo(x, place.bottom());
    lines.lineTo(x + place.height(), place.top());
  }
  painter->save();
  painter->setClipRect(place, Qt::IntersectClip);
  painter->setPen(QPen(colour, 1.0));
  painter->drawPath(lines);
  painter->restore();
}

}  // namespace umbra
