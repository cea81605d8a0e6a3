// Which texels of a map a widget shows, and how large.
#pragma once

#include <QPointF>
#include <QRect>
#include <QSize>
#include <optional>

class QWidget;

namespace umbra {

// Texel (x, y) covers [x, x+1) × [y, y+1) of the map; x to the right, y down, from 0. Points and
// rectangles of the widget are in its pixels (logical), from its upper left corner.
class TexelZoom {
 public:
  // The zoom of what `widget` shows, which must live as long.
  explicit TexelZoom(const QWidget& widget) : widget_(widget) {}

  void setMap(const QSize& texels) { map_ = texels; }
  // Must be called after the widget's size has changed: a map that was fitted still is, else the
  // scale stays.
  void follow();

  // Shows the whole map, also when the widget's size changes.
  void fit();
  // Shows `texels` in the middle, filling about two thirds of the widget.
  void show(const QRect& texels);
  // Magnifies `factor` times about a point of the widget, which stays over its texel.
  void zoomAbout(const QPointF& point, double factor);
  // Moves the map by widget pixels.
  void pan(const QPointF& by);

  // Widget pixels per texel.
  double scale() const { return scale_; }
  // The column of the texel at the widget's x, and the row of the one at its y; beside the map both
  // go on counting.
  double column(double x) const;
  double row(double y) const;
  // None where the point is beside the map.
  std::optional<QPoint> texelAt(const QPointF& point) const;
  QRectF rectOfTexels(const QRect& texels) const;
  QRect visibleTexels() const;

 private:
  void setView(double scale, const QPointF& centre);

  const QWidget& widget_;
  QSize map_;
  double scale_ = 1.0;
  QPointF centre_;  // of the widget, in texels
  bool fitted_ = true;
};

}  // namespace umbra
