#include "ui/plots/SeriesItem.h"

#include <qwt_clipper.h>
#include <qwt_graphic.h>
#include <qwt_painter.h>
#include <qwt_scale_map.h>

#include <QPainter>
#include <algorithm>

#include "ui/plots/PlotStyle.h"

namespace umbra {
namespace {

constexpr double pixelsPerPoint = 96.0 / 72.0;  // pens are in pixels of the screen
constexpr double pointRadius = 3.0;             // pixels

std::size_t pointsOf(const PlotSeries& series) {
  return std::min(series.x.size(), series.y.size());
}

}  // namespace

SeriesItem::SeriesItem(const PlotSeries& series)
    : series_(series), colour_(QString::fromStdString(series.colour)) {
  setTitle(styledText(series.name, TextRole::Legend));
  setLegendIconSize(QSize(18, 8));
  setItemAttribute(QwtPlotItem::AutoScale);
  setRenderHint(QwtPlotItem::RenderAntialiased);
}

QPen SeriesItem::pen() const {
  return QPen(colour_, series_.lineWidth * pixelsPerPoint,
              series_.dashed ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
}

QPolygonF SeriesItem::outline(const QwtScaleMap& xMap, const QwtScaleMap& yMap) const {
  QPolygonF points;
  for (std::size_t i = 0; i < pointsOf(series_); ++i) {
    const QPointF point(xMap.transform(series_.x[i]), yMap.transform(series_.y[i]));
    if (series_.style == SeriesStyle::Steps && i > 0)
      points.append(QPointF(point.x(), points.back().y()));
    points.append(point);
  }
  return points;
}

void SeriesItem::drawBars(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                          const QRectF& canvas) const {
  painter->setPen(Qt::NoPen);
  painter->setBrush(colour_);
  for (std::size_t i = 0; i + 1 < series_.x.size() && i < series_.y.size(); ++i) {
    if (series_.y[i] <= 0.0) continue;
    QRectF bar(QPointF(xMap.transform(series_.x[i]), yMap.transform(series_.y[i])),
               QPointF(xMap.transform(series_.x[i + 1]), yMap.transform(0.0)));
    // A gap keeps neighbours apart, but narrow bars stay whole, so that they can be seen.
    if (bar.width() > 4.0) bar.adjust(0.5, 0.0, -0.5, 0.0);
    if (bar.width() < 1.0) bar.adjust(-0.5, 0.0, 0.5, 0.0);
    if (bar.height() < 1.0) bar.setTop(bar.bottom() - 1.0);
    painter->drawRect(bar & canvas);
  }
}

void SeriesItem::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                      const QRectF& canvas) const {
  painter->save();
  if (series_.style == SeriesStyle::Bars) {
    drawBars(painter, xMap, yMap, canvas);
  } else if (series_.style == SeriesStyle::Points) {
    painter->setPen(QPen(Qt::white, 0.6));
    painter->setBrush(colour_);
    for (const QPointF& point : outline(xMap, yMap))
      if (canvas.contains(point)) painter->drawEllipse(point, pointRadius, pointRadius);
  } else {
    painter->setPen(pen());
    const double margin = pen().widthF();
    const QRectF clip = canvas.adjusted(-margin, -margin, margin, margin);
    painter->drawPolyline(QwtClipper::clipPolygonF(clip, outline(xMap, yMap)));
  }
  painter->restore();
}

QRectF SeriesItem::boundingRect() const {
  if (series_.x.empty() || series_.y.empty()) return {0.0, 0.0, -1.0, -1.0};  // Qwt's "nothing"
  const auto [left, right] = std::minmax_element(series_.x.begin(), series_.x.end());
  auto [low, high] = std::minmax_element(series_.y.begin(), series_.y.end());
  const double bottom = series_.style == SeriesStyle::Bars ? std::min(0.0, *low) : *low;
  return {*left, bottom, *right - *left, *high - bottom};
}

QwtGraphic SeriesItem::legendIcon(int, const QSizeF& size) const {
  QwtGraphic icon;
  icon.setDefaultSize(size);
  icon.setRenderHint(QwtGraphic::RenderPensUnscaled);
  QPainter painter(&icon);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF middle(size.width() / 2, size.height() / 2);
  if (series_.style == SeriesStyle::Bars) {
    painter.fillRect(QRectF(QPointF(0, 0), size), colour_);
  } else if (series_.style == SeriesStyle::Points) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour_);
    painter.drawEllipse(middle, pointRadius, pointRadius);
  } else {
    painter.setPen(pen());
    painter.drawLine(QPointF(0, middle.y()), QPointF(size.width(), middle.y()));
  }
  return icon;
}

}  // namespace umbra
