#include "ui/picture/SceneOverlay.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

const QColor box{0x1f, 0x29, 0x33, 0xee};
const QColor boxText{0xff, 0xff, 0xff};
const QColor boxError{0xff, 0x9a, 0xa8};  // style::error, light enough to read on `box`
const QColor boxCalm{0xc5, 0xcd, 0xd6};

constexpr double smallestPatch = 14.0;  // logical pixels

QPen dashedPen(double width) {
  QPen pen(style::probe, width);
  pen.setDashPattern({4.0, 3.0});
  pen.setCapStyle(Qt::FlatCap);
  return pen;
}

// A line that reads on light and dark ground alike.
void drawOutlined(QPainter& painter, const QPainterPath& path, const QPen& pen) {
  painter.strokePath(path, QPen(QColor(0x1f, 0x29, 0x33, 0x90), pen.widthF() + 2.0));
  painter.strokePath(path, pen);
}

QFont demiBold(QFont font) {
  font.setWeight(QFont::DemiBold);
  return font;
}

}  // namespace

SceneOverlay::SceneOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void SceneOverlay::setContents(Contents contents) {
  contents_ = std::move(contents);
  const auto& report = contents_.report;
  const bool pinned = report && report->pinned && report->point;
  handle_.place(contents_.light, pinned ? *report->point : contents_.light.target,
                contents_.projection);
  update();
}

void SceneOverlay::setHandleHot(bool hot) {
  if (hot == hot_) return;
  hot_ = hot;
  update();
}

void SceneOverlay::paintEvent(QPaintEvent*) {
  if (contents_.projection.size().isEmpty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawCurtain(painter);
  drawSelection(painter);
  drawRay(painter);
  drawPatch(painter);
  drawSun(painter);
  drawSaved(painter);
  drawFigures(painter);
  drawHint(painter);
  drawFrame(painter);
}

void SceneOverlay::drawCurtain(QPainter& painter) const {
  if (contents_.curtain.isNull() && contents_.curtainText.isEmpty()) return;
  const double at = contents_.curtainAt * width();
  const QRectF part = contents_.curtainLeft ? QRectF(0.0, 0.0, at, height())
                                            : QRectF(at, 0.0, width() - at, height());
  painter.save();
  painter.setClipRect(part);
  if (!contents_.curtain.isNull()) {
    painter.drawImage(QRectF(rect()), contents_.curtain);
  } else {
    painter.fillRect(part, style::ground);
    painter.setPen(style::muted);
    painter.drawText(part.adjusted(16.0, 8.0, -16.0, -8.0), Qt::AlignCenter | Qt::TextWordWrap,
                     contents_.curtainText);
  }
  painter.restore();
}

void SceneOverlay::drawSelection(QPainter& painter) const {
  if (contents_.selection.isEmpty()) return;
  QPainterPath path;
  path.addPolygon(contents_.selection);
  path.closeSubpath();
  drawOutlined(painter, path, QPen(style::accent.lighter(140), 1.6));
}

void SceneOverlay::drawRay(QPainter& painter) const {
  const auto& report = contents_.report;
  const bool pinned = report && report->pinned;
  const Light& light = contents_.light;
  if (report && report->point) {
    const Eigen::Vector3d towards = light.kind == LightKind::Directional
                                        ? Eigen::Vector3d(light.position - light.target)
                                        : Eigen::Vector3d(light.position - *report->point);
    const Eigen::Vector3d end =
        pinned && handle_.position() ? handle_.world() : Eigen::Vector3d(*report->point + towards);
    painter.setPen(dashedPen(1.6));
    if (const auto line = contents_.projection.toWidget(*report->point, end))
      painter.drawLine(*line);
  }
  if (!pinned && handle_.position()) {
    QPen faint = dashedPen(1.0);
    faint.setColor(QColor(style::probe.red(), style::probe.green(), style::probe.blue(), 0x80));
    painter.setPen(faint);
    if (const auto line = contents_.projection.toWidget(light.target, handle_.world()))
      painter.drawLine(*line);
  }
}

void SceneOverlay::drawPatch(QPainter& painter) const {
  const auto& report = contents_.report;
  if (!report || !report->point) return;
  QPolygonF outline;
  for (const Eigen::Vector3d& corner : report->footprint) {
    const auto point = contents_.projection.toWidget(corner);
    if (!point) return;
    outline << *point;
  }
  QPainterPath path;
  path.addPolygon(outline);
  path.closeSubpath();
  painter.fillPath(path,
                   QColor(style::probe.red(), style::probe.green(), style::probe.blue(), 0x30));
  drawOutlined(painter, path, QPen(style::probe, 1.8));
  const auto centre = contents_.projection.toWidget(*report->point);
  if (!centre) return;
  // A patch of a few pixels is easily missed: a ring says where to look.
  const QRectF bounds = outline.boundingRect();
  if (std::max(bounds.width(), bounds.height()) < smallestPatch) {
    QPainterPath ring;
    ring.addEllipse(*centre, 0.75 * smallestPatch, 0.75 * smallestPatch);
    drawOutlined(painter, ring, QPen(style::probe, 1.6));
  }
  painter.setPen(QPen(style::probe, 1.0));
  painter.setBrush(Qt::white);
  painter.drawEllipse(*centre, 2.0, 2.0);
}

void SceneOverlay::drawSun(QPainter& painter) const {
  const auto centre = handle_.position();
  if (!centre) return;
  const double radius = hot_ ? 9.5 : 8.0;
  painter.setPen(QPen(style::probe, hot_ ? 2.4 : 2.0, Qt::SolidLine, Qt::RoundCap));
  for (int i = 0; i < 8; ++i) {
    const double angle = i * 3.14159265358979 / 4.0;
    const QPointF way(std::cos(angle), std::sin(angle));
    painter.drawLine(*centre + way * (radius + 3.0), *centre + way * (radius + 6.5));
  }
  painter.setPen(QPen(QColor(0xff, 0xff, 0xff, 0xe0), 1.5));
  painter.setBrush(style::probe);
  painter.drawEllipse(*centre, radius, radius);
}

void SceneOverlay::drawSaved(QPainter& painter) const {
  std::vector<QRectF> avoid;
  if (const auto figures = figuresPlace()) avoid.push_back(*figures);
  if (const auto sun = handle_.position())
    avoid.emplace_back(*sun - QPointF(16.0, 16.0), QSizeF(32.0, 32.0));
  drawMarks(painter, contents_.marks, contents_.projection, QRectF(rect()), avoid);
}

// The box beside the probe; none without a probe in the picture.
std::optional<QRectF> SceneOverlay::figuresPlace() const {
  const auto& report = contents_.report;
  if (!report || !report->point || contents_.heading.isEmpty()) return std::nullopt;
  const auto point = contents_.projection.toWidget(*report->point);
  if (!point || !QRectF(rect()).contains(*point)) return std::nullopt;
  const QFont plain = style::figures(font()), bold = demiBold(plain);
  const QFontMetricsF boldMetrics(bold), plainMetrics(plain);
  const double line = std::ceil(std::max(boldMetrics.height(), plainMetrics.height()));
  const QSizeF size(std::ceil(std::max(boldMetrics.horizontalAdvance(contents_.heading),
                                       plainMetrics.horizontalAdvance(contents_.verdict))) +
                        24.0,
                    2.0 * line + 18.0);
  // Below and to the right of the point; on the other side where there is no room.
  QPointF corner = *point + QPointF(22.0, 16.0);
  if (corner.x() + size.width() > width() - 6.0) corner.setX(point->x() - 22.0 - size.width());
  if (corner.y() + size.height() > height() - 6.0) corner.setY(point->y() - 16.0 - size.height());
  corner.setX(std::max(corner.x(), 6.0));
  corner.setY(std::max(corner.y(), 6.0));
  return QRectF(corner, size);
}

void SceneOverlay::drawFigures(QPainter& painter) const {
  const auto frame = figuresPlace();
  if (!frame) return;
  const QFont plain = style::figures(font()), bold = demiBold(plain);
  painter.setPen(Qt::NoPen);
  painter.setBrush(box);
  painter.drawRoundedRect(*frame, 5.0, 5.0);
  const QRectF inner = frame->adjusted(12.0, 8.0, -12.0, -8.0);
  painter.setFont(bold);
  painter.setPen(boxText);
  painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop, contents_.heading);
  painter.setFont(plain);
  painter.setPen(contents_.wrong ? boxError : boxCalm);
  painter.drawText(inner, Qt::AlignLeft | Qt::AlignBottom, contents_.verdict);
}

void SceneOverlay::drawHint(QPainter& painter) const {
  if (contents_.hint.isEmpty()) return;
  // On more lines where the picture is narrow.
  const double room = std::max(60.0, width() - 44.0);
  const QRectF text = QFontMetricsF(font()).boundingRect(
      QRectF(0.0, 0.0, room, height()), Qt::AlignCenter | Qt::TextWordWrap, contents_.hint);
  const QSizeF size(text.width() + 28.0, text.height() + 12.0);
  const QRectF frame(QPointF((width() - size.width()) / 2.0, height() - size.height() - 12.0),
                     size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0xff, 0xff, 0xff, 0xe6));
  painter.drawRoundedRect(frame, 13.0, 13.0);
  painter.setPen(style::ink);
  painter.drawText(frame.adjusted(13.0, 0.0, -13.0, 0.0), Qt::AlignCenter | Qt::TextWordWrap,
                   contents_.hint);
}

void SceneOverlay::drawFrame(QPainter& painter) const {
  if (!contents_.framed) return;
  painter.setPen(QPen(style::accent, 4.0));  // the outer half is cut off
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect());
}

}  // namespace umbra
