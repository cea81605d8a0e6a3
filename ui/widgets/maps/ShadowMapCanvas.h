// One channel of a shadow map as a picture that can be zoomed to single texels.
#pragma once

#include <QImage>
#include <QPointF>
#include <QWidget>
#include <optional>

#include "filters/core/maps/Image.h"
#include "filters/core/maps/Region.h"
#include "ui/widgets/maps/TexelColours.h"
#include "ui/widgets/maps/TexelZoom.h"

namespace umbra {

// The wheel zooms, a drag moves the map, a click names a texel, a double click fits.
class ShadowMapCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit ShadowMapCanvas(QWidget* parent = nullptr);

  // Shows one channel. NaN and infinities have a colour of their own. Where the map's size is the
  // same, the zoom stays.
  void setValues(Image<float> values);
  void setColourMap(ColourMap map);
  ColourMap colourMap() const { return colours_.colourMap(); }
  void setRegion(const std::optional<Region>& region);

  // fit shows the whole map; showRegion makes the region fill about two thirds of the canvas, and
  // fits where there is none.
  void fit();
  void showRegion();
  // Magnifies `factor` times about a point of the widget, which stays over its texel.
  void zoomAbout(const QPointF& point, double factor);

  // The smallest and largest finite value of the whole map; 0 and 1 where there is none.
  double low() const { return colours_.low(); }
  double high() const { return colours_.high(); }
  bool empty() const { return colours_.values().empty(); }
  float valueAt(const QPoint& texel) const { return colours_.values()(texel.x(), texel.y()); }

  // Widget pixels per texel.
  double scale() const { return zoom_.scale(); }
  std::optional<QPoint> texelAt(const QPointF& point) const { return zoom_.texelAt(point); }
  // In widget pixels.
  QRectF rectOfTexels(const QRect& texels) const { return zoom_.rectOfTexels(texels); }
  QRect regionTexels() const;  // empty without a region

  QSize sizeHint() const override { return {240, 220}; }
  QSize minimumSizeHint() const override { return {80, 80}; }

 signals:
  void texelHovered(int x, int y);
  void texelClicked(int x, int y);
  void left();  // the pointer is on no texel

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void redraw();
  QFont figureFont() const;
  bool showsFigures() const;  // the texels are large enough for their values
  void drawGrid(QPainter& painter) const;
  void drawValues(QPainter& painter) const;
  void drawRegion(QPainter& painter) const;

  TexelColours colours_;
  TexelZoom zoom_;
  std::optional<Region> region_;
  QImage visible_;  // what paintEvent shows, in device pixels
  bool visibleStale_ = true;
  std::optional<QPointF> dragFrom_;
  bool dragged_ = false;
};

}  // namespace umbra
