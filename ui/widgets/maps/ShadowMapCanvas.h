// One channel of a shadow map as a picture that can be zoomed to single texels.
#pragma once

#include <QImage>
#include <QPointF>
#include <QWidget>
#include <optional>
#include <vector>

#include "filters/core/maps/Image.h"
#include "filters/core/maps/Region.h"
#include "ui/widgets/maps/ColourMap.h"

namespace umbra {

// Texel (x, y) covers [x, x+1) × [y, y+1) of the map; x to the right, y down, from 0.
class ShadowMapCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit ShadowMapCanvas(QWidget* parent = nullptr);

  // One channel; NaN and infinities are drawn apart. The zoom stays where the size does.
  void setValues(Image<float> values);
  void setColourMap(ColourMap map);
  ColourMap colourMap() const { return colourMap_; }
  void setRegion(const std::optional<Region>& region);

  // The whole map; and the region at about two thirds of the canvas (fit where there is none).
  void fit();
  void showRegion();
  // Magnifies `factor` times about a point of the widget, which stays over its texel.
  void zoomAbout(const QPointF& point, double factor);

  // Finite values of the whole map; 0 … 1 where there are none.
  double low() const { return low_; }
  double high() const { return high_; }
  bool empty() const { return values_.empty(); }
  float valueAt(const QPoint& texel) const { return values_(texel.x(), texel.y()); }

  // Widget pixels per texel.
  double scale() const { return scale_; }
  std::optional<QPoint> texelAt(const QPointF& point) const;
  QRectF rectOfTexels(const QRect& texels) const;  // in widget pixels
  QRect regionTexels() const;                      // empty without a region

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
  void setView(double scale, const QPointF& centre);  // centre in texels
  void renderVisible();
  QFont figureFont() const;
  bool showsFigures() const;  // the texels are large enough for their values
  void drawGrid(QPainter& painter) const;
  void drawValues(QPainter& painter) const;
  void drawRegion(QPainter& painter) const;
  QRect visibleTexels() const;

  Image<float> values_;
  std::vector<unsigned char> shades_;  // values_ as entries of the colour table
  float low_ = 0.0F, high_ = 1.0F;
  ColourMap colourMap_ = ColourMap::Viridis;
  std::optional<Region> region_;

  double scale_ = 1.0;  // widget pixels per texel
  QPointF centre_;      // of the widget, in texels
  bool fitted_ = true;  // the whole map follows the widget's size
  QImage visible_;      // what paintEvent shows, in device pixels
  bool visibleStale_ = true;
  std::optional<QPointF> dragFrom_;
  bool dragged_ = false;
};

}  // namespace umbra
