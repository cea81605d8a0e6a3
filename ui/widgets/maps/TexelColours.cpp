#include "ui/widgets/maps/TexelColours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "ui/widgets/base/Style.h"
#include "ui/widgets/maps/TexelZoom.h"

namespace umbra {
namespace {

// Entry 0 stands for values that are no number, 1 … 255 for the colour table.
std::vector<unsigned char> shadesOf(std::span<const float> values, float low, float high) {
  std::vector<unsigned char> shades(values.size());
  const float factor = high > low ? 254.0F / (high - low) : 0.0F;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float value = values[i];
    shades[i] =
        std::isfinite(value) ? static_cast<unsigned char>(1.5F + (value - low) * factor) : 0;
  }
  return shades;
}

QRgb colourOfShade(ColourMap map, int shade) {
  return shade == 0 ? qRgb(0xff, 0xff, 0xff) : colourTable(map)[std::size_t(shade)];
}

// The texel that each of `pixels` device pixels shows along one axis; −1 beside the map.
template <class TexelOf>
std::vector<int> texelsAlong(int pixels, int texels, double ratio, const TexelOf& texelOf) {
  std::vector<int> along(static_cast<std::size_t>(pixels));
  for (int pixel = 0; pixel < pixels; ++pixel) {
    const double texel = texelOf((pixel + 0.5) / ratio);
    along[std::size_t(pixel)] = texel >= 0 && texel < texels ? int(texel) : -1;
  }
  return along;
}

}  // namespace

void TexelColours::setValues(Image<float> values) {
  values_ = std::move(values);
  bool any = false;
  low_ = 0.0F;
  high_ = 1.0F;
  for (float value : values_.values()) {
    if (!std::isfinite(value)) continue;
    low_ = any ? std::min(low_, value) : value;
    high_ = any ? std::max(high_, value) : value;
    any = true;
  }
  shades_ = shadesOf(values_.values(), low_, high_);
}

QRgb TexelColours::colourAt(int x, int y) const {
  const std::size_t at = std::size_t(y) * std::size_t(values_.width()) + std::size_t(x);
  return colourOfShade(colourMap_, shades_[at]);
}

QImage TexelColours::draw(const TexelZoom& zoom, const QSize& size, double ratio) const {
  const QSize pixels(int(std::ceil(size.width() * ratio)), int(std::ceil(size.height() * ratio)));
  QImage image(pixels, QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(style::ground);
  std::array<QRgb, 256> colours{};
  for (int shade = 0; shade < 256; ++shade)
    colours[std::size_t(shade)] = colourOfShade(colourMap_, shade);
  const std::vector<int> columns =
      texelsAlong(pixels.width(), values_.width(), ratio, [&](double x) { return zoom.column(x); });
  const std::vector<int> rows =
      texelsAlong(pixels.height(), values_.height(), ratio, [&](double y) { return zoom.row(y); });
  int rowBefore = -1;
  for (int py = 0; py < pixels.height(); ++py) {
    const int row = rows[std::size_t(py)];
    if (row < 0) continue;
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(py));
    if (row == rowBefore) {
      std::memcpy(line, image.constScanLine(py - 1), std::size_t(pixels.width()) * sizeof(QRgb));
      continue;
    }
    const unsigned char* shades = shades_.data() + std::size_t(row) * std::size_t(values_.width());
    for (std::size_t px = 0; px < columns.size(); ++px)
      if (columns[px] >= 0) line[px] = colours[shades[columns[px]]];
    rowBefore = row;
  }
  return image;
}

}  // namespace umbra
