#include "ui/widgets/maps/ShadowMapCanvas.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr double largestScale = 160.0;  // widget pixels per texel
constexpr double gridFrom = 6.0;        // from this scale on texels have lines between them
constexpr double regionShare = 2.0 / 3.0;

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

}  // namespace

ShadowMapCanvas::ShadowMapCanvas(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ShadowMapCanvas::setValues(Image<float> values) {
  const bool sameSize = values.width() == values_.width() && values.height() == values_.height();
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
  visibleStale_ = true;
  if (!sameSize) fit();
  update();
}

void ShadowMapCanvas::setColourMap(ColourMap map) {
  colourMap_ = map;
  visibleStale_ = true;
  update();
}

void ShadowMapCanvas::setRegion(const std::optional<Region>& region) {
  region_ = region;
  update();
}

void ShadowMapCanvas::setView(double scale, const QPointF& centre) {
  const double smallest = std::min({double(width()) / std::max(values_.width(), 1),
                                    double(height()) / std::max(values_.height(), 1), 1.0});
  scale_ = std::clamp(scale, smallest, largestScale);
  centre_ = {std::clamp(centre.x(), 0.0, double(values_.width())),
             std::clamp(centre.y(), 0.0, double(values_.height()))};
  visibleStale_ = true;
  update();
}

void ShadowMapCanvas::fit() {
  fitted_ = true;
  if (empty()) return;
  setView(std::min(double(width()) / values_.width(), double(height()) / values_.height()),
          {values_.width() / 2.0, values_.height() / 2.0});
}

void ShadowMapCanvas::showRegion() {
  const QRect texels = regionTexels();
  if (texels.isEmpty()) return fit();
  fitted_ = false;
  const double side = std::max(texels.width(), texels.height());
  setView(regionShare * std::min(width(), height()) / side, QRectF(texels).center());
}

void ShadowMapCanvas::zoomAbout(const QPointF& point, double factor) {
  if (empty()) return;
  const QPointF middle(width() / 2.0, height() / 2.0);
  const QPointF under = centre_ + (point - middle) / scale_;
  fitted_ = false;
  setView(scale_ * factor, centre_);
  setView(scale_, under - (point - middle) / scale_);
}

std::optional<QPoint> ShadowMapCanvas::texelAt(const QPointF& point) const {
  const double x = std::floor(centre_.x() + (point.x() - width() / 2.0) / scale_);
  const double y = std::floor(centre_.y() + (point.y() - height() / 2.0) / scale_);
  if (!(x >= 0 && y >= 0 && x < values_.width() && y < values_.height())) return std::nullopt;
  return QPoint(int(x), int(y));
}

QRectF ShadowMapCanvas::rectOfTexels(const QRect& texels) const {
  return {width() / 2.0 + (texels.x() - centre_.x()) * scale_,
          height() / 2.0 + (texels.y() - centre_.y()) * scale_, texels.width() * scale_,
          texels.height() * scale_};
}

QRect ShadowMapCanvas::regionTexels() const {
  if (!region_ || region_->texels.empty()) return {};
  QRect bounds(region_->texels.front().x, region_->texels.front().y, 1, 1);
  for (const RegionTexel& texel : region_->texels) bounds |= QRect(texel.x, texel.y, 1, 1);
  return bounds;
}

QRect ShadowMapCanvas::visibleTexels() const {
  const auto first = [](double centre, double half) { return int(std::floor(centre - half)); };
  const double halfWidth = width() / 2.0 / scale_, halfHeight = height() / 2.0 / scale_;
  const QPoint topLeft(first(centre_.x(), halfWidth), first(centre_.y(), halfHeight));
  const QPoint bottomRight(first(centre_.x(), -halfWidth), first(centre_.y(), -halfHeight));
  return QRect(topLeft, bottomRight) & QRect(0, 0, values_.width(), values_.height());
}

// One look-up per device pixel, by the same rule as texelAt: what the cursor names is what is
// drawn, at every zoom, and the cost does not depend on the size of the map.
void ShadowMapCanvas::renderVisible() {
  const double ratio = devicePixelRatioF();
  const QSize pixels(int(std::ceil(width() * ratio)), int(std::ceil(height() * ratio)));
  visible_ = QImage(pixels, QImage::Format_RGB32);
  visible_.setDevicePixelRatio(ratio);
  visible_.fill(style::ground);
  std::array<QRgb, 256> colours{};
  for (int shade = 0; shade < 256; ++shade)
    colours[std::size_t(shade)] = colourOfShade(colourMap_, shade);

  const auto texelOf = [&](int pixel, double centre, int extent, int count) {
    const double texel = std::floor(centre + ((pixel + 0.5) / ratio - extent / 2.0) / scale_);
    return texel >= 0 && texel < count ? int(texel) : -1;
  };
  std::vector<int> columns(std::size_t(pixels.width()));
  for (int px = 0; px < pixels.width(); ++px)
    columns[std::size_t(px)] = texelOf(px, centre_.x(), width(), values_.width());

  int rowBefore = -1;
  for (int py = 0; py < pixels.height(); ++py) {
    const int row = texelOf(py, centre_.y(), height(), values_.height());
    if (row < 0) continue;
    auto* line = reinterpret_cast<QRgb*>(visible_.scanLine(py));
    if (row == rowBefore) {
      std::memcpy(line, visible_.constScanLine(py - 1), std::size_t(pixels.width()) * sizeof(QRgb));
      continue;
    }
    const unsigned char* shades = shades_.data() + std::size_t(row) * std::size_t(values_.width());
    for (std::size_t px = 0; px < columns.size(); ++px)
      if (columns[px] >= 0) line[px] = colours[shades[columns[px]]];
    rowBefore = row;
  }
  visibleStale_ = false;
}

void ShadowMapCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (empty()) {
    painter.fillRect(rect(), style::ground);
    painter.setPen(style::muted);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No shadow map yet"));
    return;
  }
  if (visibleStale_ || visible_.devicePixelRatio() != devicePixelRatioF()) renderVisible();
  painter.drawImage(0, 0, visible_);
  if (scale_ >= gridFrom) drawGrid(painter);
  if (showsFigures()) drawValues(painter);
  drawRegion(painter);
}

void ShadowMapCanvas::drawGrid(QPainter& painter) const {
  const QRect texels = visibleTexels();
  const QRectF area = rectOfTexels(texels);
  painter.setPen(QPen(QColor(255, 255, 255, scale_ < 2 * gridFrom ? 60 : 120), 1.0));
  for (int i = 0; i <= texels.width(); ++i) {
    const double x = area.left() + i * scale_;
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  }
  for (int i = 0; i <= texels.height(); ++i) {
    const double y = area.top() + i * scale_;
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
  }
}

QFont ShadowMapCanvas::figureFont() const {
  QFont small = style::figures(font());
  small.setPixelSize(std::max(9, QFontInfo(font()).pixelSize() - 2));
  return small;
}

bool ShadowMapCanvas::showsFigures() const {
  return QFontMetricsF(figureFont()).horizontalAdvance("0.0000") + 6 <= scale_;
}

void ShadowMapCanvas::drawValues(QPainter& painter) const {
  painter.setFont(figureFont());
  const QRect texels = visibleTexels();
  for (int y = texels.top(); y <= texels.bottom(); ++y)
    for (int x = texels.left(); x <= texels.right(); ++x) {
      const std::size_t at = std::size_t(y) * std::size_t(values_.width()) + std::size_t(x);
      const bool light = qGray(colourOfShade(colourMap_, shades_[at])) > 140;
      painter.setPen(light ? style::ink : QColor(Qt::white));
      painter.drawText(rectOfTexels({x, y, 1, 1}), Qt::AlignCenter, style::figure(values_(x, y)));
    }
}

void ShadowMapCanvas::drawRegion(QPainter& painter) const {
  const QRect texels = regionTexels();
  if (texels.isEmpty()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QRectF outline = rectOfTexels(texels);
  // A dark line beneath keeps the amber visible on yellow depths.
  for (const QPen& pen : {QPen(QColor(31, 41, 51, 140), 4.0), QPen(style::probe, 2.0)}) {
    painter.setPen(pen);
    painter.drawRect(outline);
    // Too small to be found: a ring around it.
    if (std::max(outline.width(), outline.height()) < 14.0)
      painter.drawEllipse(outline.center(), 14.0, 14.0);
  }
  const QRectF texel = rectOfTexels({region_->x, region_->y, 1, 1});
  if (texel.width() < 3.0) return;
  const double radius = std::clamp(texel.width() / 4.0, 2.0, 6.0);
  // In a corner of the texel where there is a figure in the middle.
  const QPointF mark =
      showsFigures() ? texel.topLeft() + QPointF(radius + 4, radius + 4) : texel.center();
  painter.setPen(QPen(Qt::white, 1.0));
  painter.setBrush(style::probe);
  painter.drawEllipse(mark, radius, radius);
}

}  // namespace umbra
