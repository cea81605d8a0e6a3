#include "ui/picture/ProbeMarks.h"

#include <QFontMetricsF>
#include <algorithm>
#include <optional>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr double radius = 8.5;  // of a disc, logical pixels
constexpr double widestName = 140.0;
const QColor plate{0x1f, 0x29, 0x33, 0xc8};

struct PlacedMark {
  const ProbeMark* mark;
  QPointF centre;
};

// Beside the disc, on whichever side is free.
std::optional<QRectF> placeOfName(const QPointF& centre, const QSizeF& size, const QRectF& area,
                                  const std::vector<QRectF>& taken) {
  const double gap = radius + 3.0;
  const QPointF corners[] = {{gap, -size.height() / 2.0},
                             {-gap - size.width(), -size.height() / 2.0},
                             {-size.width() / 2.0, gap},
                             {-size.width() / 2.0, -gap - size.height()},
                             {gap, gap - 4.0},
                             {-gap - size.width(), -gap - size.height() + 4.0}};
  for (const QPointF& corner : corners) {
    const QRectF place(centre + corner, size);
    const bool free = std::none_of(taken.begin(), taken.end(),
                                   [&](const QRectF& other) { return other.intersects(place); });
    if (free && area.contains(place)) return place;
  }
  return std::nullopt;
}

void drawDisc(QPainter& painter, const PlacedMark& placed) {
  const QRectF disc(placed.centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
  const QColor light(0xff, 0xff, 0xff, 0xe0);
  const bool hidden = placed.mark->hidden;
  painter.setPen(QPen(hidden ? style::probe : light, 1.5));
  painter.setBrush(hidden ? light : style::probe);
  painter.drawEllipse(disc);
  painter.setPen(style::ink);
  painter.drawText(disc, Qt::AlignCenter, QString::number(placed.mark->number));
}

}  // namespace

void drawMarks(QPainter& painter, const std::vector<ProbeMark>& marks,
               const SceneProjection& projection, const QRectF& area,
               const std::vector<QRectF>& avoid) {
  std::vector<PlacedMark> placed;
  std::vector<QRectF> taken = avoid;
  for (const ProbeMark& mark : marks) {
    const auto centre = projection.toWidget(mark.point);
    if (!centre || !area.contains(*centre)) continue;
    placed.push_back({&mark, *centre});
    taken.emplace_back(*centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
  }
  const QFont names = painter.font();
  QFont numbers = style::figures(names);
  numbers.setBold(true);
  numbers.setPointSizeF(numbers.pointSizeF() * 0.82);
  const QFontMetricsF metrics(names);
  for (const PlacedMark& each : placed) {
    const QString name = metrics.elidedText(each.mark->name, Qt::ElideRight, widestName);
    const QSizeF size(metrics.horizontalAdvance(name) + 10.0, metrics.height() + 2.0);
    if (const auto place = placeOfName(each.centre, size, area, taken)) {
      taken.push_back(*place);
      painter.setFont(names);
      painter.setPen(Qt::NoPen);
      painter.setBrush(plate);
      painter.drawRoundedRect(*place, 3.0, 3.0);
      painter.setPen(Qt::white);
      painter.drawText(*place, Qt::AlignCenter, name);
    }
    painter.setFont(numbers);
    drawDisc(painter, each);
  }
  painter.setFont(names);
}

}  // namespace umbra
