#include "ui/widgets/maps/ColourBar.h"

#include <QPainter>

#include "filters/gpu/ViewColours.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int barHeight = 10;
constexpr int tickLength = 3;

}  // namespace

ColourBar::ColourBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ColourBar::setScale(ColourMap map, double low, double high, const QString& label) {
  map_ = map;
  low_ = low;
  high_ = high;
  label_ = label;
  setToolTip(QString("%1: %2 … %3").arg(label, style::figure(low), style::figure(high)));
  updateGeometry();
  update();
}

void ColourBar::setLabel(const QString& label) {
  label_ = label;
  update();
}

void ColourBar::setView(const FrameSettings& settings) {
  const double errors = settings.errorRange;
  notice_ = false;
  cascades_ = settings.view == ViewMode::Cascades ? settings.map.cascades.count : 0;
  switch (settings.view) {
    case ViewMode::Visibility:
      setScale(ColourMap::Grey, 0.0, 1.0, tr("visibility v"));
      break;
    case ViewMode::Error:
      setScale(ColourMap::Diverging, -errors, errors, tr("error v − v_ref: too dark … too light"));
      break;
    case ViewMode::Depth:
      // The picture is bright near the light: the bar runs from far to near.
      setScale(ColourMap::Grey, 1.0, 0.0, tr("light-space depth z: far … near"));
      break;
    case ViewMode::Cascades:
      label_ = tr("cascade, from the camera outwards");
      setToolTip(label_);
      updateGeometry();
      update();
      break;
    case ViewMode::Shaded:
    case ViewMode::Layers:
      setVisible(false);
      return;
  }
  setVisible(true);
}

void ColourBar::setNotice(const QString& text) {
  notice_ = true;
  label_ = text;
  setToolTip(text);
  updateGeometry();
  update();
  setVisible(true);
}

QSize ColourBar::sizeHint() const {
  if (notice_) return {220, fontMetrics().height()};
  const int lines = label_.isEmpty() ? 1 : 2;
  return {220, barHeight + tickLength + 2 + lines * fontMetrics().height()};
}

QSize ColourBar::minimumSizeHint() const {
  return {80, sizeHint().height()};
}

void ColourBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int line = fontMetrics().height();
  int top = 0;
  if (!label_.isEmpty()) {
    painter.setPen(style::muted);
    painter.drawText(QRect(0, 0, width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(label_, Qt::ElideRight, width()));
    top = line;
  }
  if (notice_) return;
  const QRect bar(0, top, width(), barHeight);
  if (cascades_ > 0) return paintCascades(painter, bar);
  QLinearGradient gradient(bar.left(), 0, bar.right() + 1, 0);
  for (int i = 0; i <= 32; ++i) gradient.setColorAt(i / 32.0, QColor(colourAt(map_, i / 32.0)));
  painter.fillRect(bar, gradient);
  painter.setPen(style::border);
  painter.drawRect(bar.adjusted(0, 0, -1, -1));

  painter.setFont(style::figures(font()));
  const int figuresTop = bar.bottom() + tickLength + 2;
  const Qt::Alignment sides[] = {Qt::AlignLeft, Qt::AlignHCenter, Qt::AlignRight};
  for (int i = 0; i <= 2; ++i) {
    const double share = i / 2.0;
    const int x = int(share * (width() - 1));
    painter.setPen(style::muted);
    painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + tickLength);
    painter.drawText(QRect(0, figuresTop, width(), line), sides[i] | Qt::AlignTop,
                     style::figure(low_ + share * (high_ - low_)));
  }
}

// A field for each cascade, with its number below.
void ColourBar::paintCascades(QPainter& painter, const QRect& bar) {
  painter.setFont(style::figures(font()));
  for (int i = 0; i < cascades_; ++i) {
    const int left = i * bar.width() / cascades_, right = (i + 1) * bar.width() / cascades_;
    const QRect field(left, bar.top(), right - left, bar.height());
    const ViewColour& colour = cascadeColours[std::size_t(i)];
    painter.fillRect(field, QColor::fromRgbF(colour[0], colour[1], colour[2]));
    painter.setPen(style::border);
    painter.drawRect(field.adjusted(0, 0, -1, -1));
    painter.setPen(style::muted);
    painter.drawText(
        QRect(left, bar.bottom() + tickLength + 2, field.width(), fontMetrics().height()),
        Qt::AlignHCenter | Qt::AlignTop, QString::number(i + 1));
  }
}

}  // namespace umbra
