// A picture to look at closely, to point at and to circle parts of with the mouse.
#pragma once

#include <QImage>
#include <QPolygonF>
#include <QWidget>
#include <optional>

namespace umbra {

// Pixel (x, y) of the picture covers [x, x+1) × [y, y+1) of its coordinates, y down. It is fitted
// into the widget; the wheel magnifies it about the pointer.
class PictureCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit PictureCanvas(QWidget* parent = nullptr);

  // Without a picture `hint` stands in its place.
  void setPicture(const QImage& picture);
  void setHint(const QString& hint);
  // A picture that no longer counts is faded. The note lies over its top.
  void setFaded(bool faded);
  void setNote(const QString& note);
  // Both in the picture's coordinates; a ring about a pixel's middle, and a closed outline.
  void setMark(const std::optional<QPointF>& mark);
  void setLasso(const QPolygonF& lasso);

  const QImage& picture() const { return picture_; }
  bool faded() const { return faded_; }
  QString shownText() const { return picture_.isNull() ? hint_ : note_; }
  QPointF toWidget(const QPointF& picture) const;
  QPointF toPicture(const QPointF& widget) const;

  QSize sizeHint() const override { return {240, 160}; }
  QSize minimumSizeHint() const override { return {100, 50}; }

 signals:
  void pixelHovered(int x, int y);
  void left();  // the pointer is on no pixel
  void pixelClicked(int x, int y);
  void lassoDrawn(const QPolygonF& lasso);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double scale() const;  // widget pixels per pixel of the picture
  std::optional<QPoint> pixelAt(const QPointF& point) const;
  bool drawing() const { return drawn_.size() > 1; }
  void drawPicture(QPainter& painter);
  void drawOutline(QPainter& painter, const QPolygonF& lasso, bool closed) const;
  void drawMark(QPainter& painter) const;
  void drawNote(QPainter& painter) const;

  QImage picture_, shrunk_;  // shrunk_: as it is shown, in device pixels
  QString hint_, note_;
  bool faded_ = false;
  std::optional<QPointF> mark_;
  QPolygonF lasso_, drawn_;  // drawn_: while the mouse draws
  std::optional<QPointF> pressed_;
  double zoom_ = 1.0;  // times the scale at which the picture fits
  QPointF centre_;     // of the widget, in the picture
};

}  // namespace umbra
