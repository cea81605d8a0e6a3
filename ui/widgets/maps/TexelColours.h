// The values of one channel as colours.
#pragma once

#include <QColor>
#include <QImage>
#include <vector>

#include "filters/core/maps/Image.h"
#include "ui/widgets/maps/ColourMap.h"

namespace umbra {

class TexelZoom;

// The colours span the finite values of the whole map. NaN and infinities have a colour of their
// own.
class TexelColours {
 public:
  void setValues(Image<float> values);
  void setColourMap(ColourMap map) { colourMap_ = map; }

  const Image<float>& values() const { return values_; }
  ColourMap colourMap() const { return colourMap_; }
  // The smallest and largest finite value; 0 and 1 where there is none.
  float low() const { return low_; }
  float high() const { return high_; }
  QRgb colourAt(int x, int y) const;

  // What a widget of `size` logical pixels shows, in device pixels, `ratio` to each logical one.
  // One look-up per pixel, by the same rule as TexelZoom::texelAt: what the pointer names is what
  // is drawn, at every zoom, and the cost does not depend on the size of the map.
  QImage draw(const TexelZoom& zoom, const QSize& size, double ratio) const;

 private:
  Image<float> values_;
  std::vector<unsigned char> shades_;  // by texel: an entry of the colour table
  float low_ = 0.0F, high_ = 1.0F;
  ColourMap colourMap_ = ColourMap::Viridis;
};

}  // namespace umbra
