// What a widget shows, by its own coordinates at any pixel density.
#pragma once

#include <QImage>
#include <QPixmap>
#include <QWidget>

namespace umbra {

class Grab {
 public:
  explicit Grab(QWidget& widget) : image_(widget.grab().toImage()) {}

  double ratio() const { return image_.devicePixelRatio(); }
  QSize devicePixels() const { return image_.size(); }
  QRgb devicePixel(int x, int y) const { return image_.pixel(x, y); }
  QRgb operator()(int x, int y) const { return image_.pixel(int(x * ratio()), int(y * ratio())); }

 private:
  QImage image_;
};

}  // namespace umbra
