#include "ui/plots/AnnotationItem.h"

#include <qwt_painter.h>
#include <qwt_scale_map.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>

#include "ui/plots/PlotStyle.h"

namespace umbra {
namespace {

constexpr double gap = 2.0;            // pixels between a label and what it names
constexpr double errorBarWidth = 5.0;  // pixels

QColor colourOf(const std::string& colour) {
  return QColor(QString::fromStdString(colour));
}

}  // namespace

struct AnnotationItem::Frame {
  QPainter* painter;
  const QwtScaleMap& xMap;
  const QwtScaleMap& yMap;
  QRectF canvas;
  LabelPlacer placer;

  QPointF at(double x, double y) const { return {xMap.transform(x), yMap.transform(y)}; }

  void drawLabel(const std::string& label, const QColor& colour, bool bold,
                 const std::function<std::vector<QRectF>(QSizeF)>& candidates) {
    if (label.empty()) return;
    const QwtText text = styledText(label, bold ? TextRole::ErrorLabel : TextRole::Label, colour);
    // Some air left and right, so that two labels in a row do not read as one.
    const QSizeF size = text.textSize(text.font()) + QSizeF(4.0, 0.0);
    const QRectF place = placer.place(candidates(size));
    // Curves that cannot be avoided shine through a little.
    painter->fillRect(place, QColor(255, 255, 255, 205));
    text.draw(painter, place);
  }
};

AnnotationItem::AnnotationItem(const Plot& plot) : plot_(plot) {
  setZ(50.0);
  setItemAttribute(QwtPlotItem::Legend, false);
  setRenderHint(QwtPlotItem::RenderAntialiased);
}

void AnnotationItem::avoidSeries(Frame& frame) const {
  for (const PlotSeries& series : plot_.series) {
    if (series.style == SeriesStyle::Bars) {
      for (std::size_t i = 0; i + 1 < series.x.size() && i < series.y.size(); ++i)
        frame.placer.avoid(
            QRectF(frame.at(series.x[i], 0.0), frame.at(series.x[i + 1], series.y[i])));
      continue;
    }
    const std::size_t points = std::min(series.x.size(), series.y.size());
    for (std::size_t i = 0; i + 1 < points; ++i) {
      const QPointF from = frame.at(series.x[i], series.y[i]);
      const QPointF to = frame.at(series.x[i + 1], series.y[i + 1]);
      if (series.style == SeriesStyle::Steps) {
        const QPointF corner(to.x(), from.y());
        frame.placer.avoid(QLineF(from, corner));
        frame.placer.avoid(QLineF(corner, to));
      } else {
        frame.placer.avoid(QLineF(from, to));
      }
    }
  }
}

void AnnotationItem::drawMarkerLine(Frame& frame, const PlotMarker& marker) const {
  const bool vertical = marker.axis == MarkerAxis::Vertical;
  const QPointF position = frame.at(marker.position, marker.position);
  const QLineF line =
      vertical ? QLineF(position.x(), frame.canvas.top(), position.x(), frame.canvas.bottom())
               : QLineF(frame.canvas.left(), position.y(), frame.canvas.right(), position.y());
  frame.painter->setPen(QPen(colourOf(marker.colour), 1.4,
                             marker.dashed ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
  QwtPainter::drawLine(frame.painter, line.p1(), line.p2());
  frame.placer.avoid(line);
}

void AnnotationItem::drawErrorBar(Frame& frame, const PlotError& error) const {
  const QPointF from = frame.at(error.x, error.from), to = frame.at(error.x, error.to);
  QColor colour = colourOf(error.colour);
  colour.setAlphaF(0.75);
  frame.painter->setPen(QPen(colour, errorBarWidth, Qt::SolidLine, Qt::FlatCap));
  QwtPainter::drawLine(frame.painter, from, to);
  frame.painter->setPen(QPen(Qt::white, 1.0));
  frame.painter->setBrush(colourOf(error.colour));
  frame.painter->drawEllipse(to, 4.0, 4.0);
  frame.placer.avoid(QRectF(QPointF(from.x() - 4.0, from.y()), QPointF(to.x() + 4.0, to.y())));
}

// The label stands along the line, from its top (or its right end) on, on one side or the other.
void AnnotationItem::drawMarkerLabel(Frame& frame, const PlotMarker& marker) const {
  const QRectF& canvas = frame.canvas;
  frame.drawLabel(marker.label, colourOf(marker.colour).darker(115), false, [&](QSizeF size) {
    std::vector<QRectF> candidates;
    const QPointF position = frame.at(marker.position, marker.position);
    if (marker.axis == MarkerAxis::Vertical) {
      const double centred = std::clamp(position.x() - size.width() / 2, canvas.left(),
                                        std::max(canvas.left(), canvas.right() - size.width()));
      for (double y = canvas.top(); y + size.height() <= canvas.bottom(); y += size.height())
        for (double x : {position.x() + gap, position.x() - gap - size.width(), centred})
          candidates.emplace_back(QPointF(x, y), size);
    } else {
      const double step = std::max(size.width() / 2, 1.0);
      for (double x = canvas.right() - size.width(); x >= canvas.left(); x -= step)
        for (double y : {position.y() - size.height() - 1, position.y() + 1})
          candidates.emplace_back(QPointF(x, y), size);
    }
    if (candidates.empty()) candidates.emplace_back(canvas.topLeft(), size);
    return candidates;
  });
}

// The label stands beside the bar: best at its end, which is the value read, else along it or
// around it.
void AnnotationItem::drawErrorLabel(Frame& frame, const PlotError& error) const {
  const QRectF& canvas = frame.canvas;
  frame.drawLabel(error.label, colourOf(error.colour), true, [&](QSizeF size) {
    std::vector<QRectF> candidates;
    const QPointF from = frame.at(error.x, error.from), to = frame.at(error.x, error.to);
    const double right = to.x() + 4 * gap, left = to.x() - 4 * gap - size.width();
    for (double along : {to.y(), (from.y() + to.y()) / 2, from.y()})
      for (double lift : {0.5, 1.0, 0.0, 1.5, -0.5, 2.0, -1.0})
        for (double x : {right, left})
          candidates.emplace_back(QPointF(x, along - lift * size.height()), size);
    // Above or below the bar's end the label need not lie beside the bar.
    const double inside =
        std::clamp(right, canvas.left(), std::max(canvas.left(), canvas.right() - size.width()));
    for (double lift : {1.5, 2.0, 2.5, -0.5, -1.0})
      candidates.emplace_back(QPointF(inside, to.y() - lift * size.height()), size);
    return candidates;
  });
}

void AnnotationItem::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                          const QRectF& canvas) const {
  Frame frame{painter, xMap, yMap, canvas, LabelPlacer(canvas)};
  painter->save();
  avoidSeries(frame);
  for (const PlotMarker& marker : plot_.markers) drawMarkerLine(frame, marker);
  for (const PlotError& error : plot_.errors) drawErrorBar(frame, error);
  for (const PlotError& error : plot_.errors) drawErrorLabel(frame, error);
  for (const PlotMarker& marker : plot_.markers) drawMarkerLabel(frame, marker);
  painter->restore();
}

}  // namespace umbra
