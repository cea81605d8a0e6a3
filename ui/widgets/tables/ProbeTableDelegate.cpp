#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/widgets/base/Style.h"
#include "ui/widgets/tables/ProbeTableModel.h"

namespace umbra {
namespace {

// A grey track from −1 to +1 with zero in the middle.
void drawBar(QPainter& painter, const QRectF& cell, double error) {
  const QRectF track(cell.left() + 6, cell.center().y() - 3, cell.width() - 12, 6);
  if (track.width() < 8) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(style::ground);
  painter.drawRoundedRect(track, 2, 2);
  const double middle = track.center().x();
  const double length = std::clamp(error, -1.0, 1.0) * track.width() / 2.0;
  if (std::abs(length) >= 0.25) {
    painter.setBrush(style::error);
    painter.drawRect(QRectF(QPointF(std::min(middle, middle + length), track.top()),
                            QSizeF(std::max(std::abs(length), 1.0), track.height())));
  }
  painter.setPen(QPen(style::muted, 1.0));
  painter.drawLine(QPointF(middle, track.top() - 2), QPointF(middle, track.bottom() + 2));
}

// The whole title where it fits, else its abbreviation: "Variance (VSM)" becomes "VSM".
QString fitted(const QString& title, const QFontMetrics& metrics, int width) {
  if (metrics.horizontalAdvance(title) <= width) return title;
  const int open = int(title.indexOf('(')), close = int(title.indexOf(')'));
  const QString brief = open >= 0 && close > open ? title.mid(open + 1, close - open - 1) : title;
  return metrics.elidedText(brief, Qt::ElideRight, width);
}

}  // namespace

void ProbeTableDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
  const QColor colour = index.data(ProbeTableModel::ColourRole).value<QColor>();
  const bool selected = option.state & QStyle::State_Selected;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (selected) painter->fillRect(option.rect, style::tint(colour));

  const int column = index.column();
  QFont font = column == ProbeTableModel::TitleColumn ? option.font : style::figures(option.font);
  font.setBold(selected);
  painter->setFont(font);
  const bool refused = !(index.flags() & Qt::ItemIsEnabled);
  painter->setPen(refused ? style::muted : style::ink);
  if (column == ProbeTableModel::BarColumn) {
    if (!refused) drawBar(*painter, option.rect, index.data(ProbeTableModel::ErrorRole).toDouble());
  } else if (column == ProbeTableModel::TitleColumn) {
    const QRect text = option.rect.adjusted(chipWidth, 0, -2, 0);
    painter->drawText(text, Qt::AlignVCenter | Qt::AlignLeft,
                      fitted(index.data().toString(), QFontMetrics(font), text.width()));
    painter->setPen(Qt::NoPen);
    painter->setBrush(colour);
    painter->drawRoundedRect(QRectF(option.rect.left() + 4, option.rect.center().y() - 4, 9, 9), 2,
                             2);
  } else {
    painter->drawText(option.rect.adjusted(0, 0, -padding, 0), Qt::AlignVCenter | Qt::AlignRight,
                      index.data().toString());
  }
  painter->setRenderHint(QPainter::Antialiasing, false);
  painter->setPen(style::border);
  painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
  painter->restore();
}

QSize ProbeTableDelegate::sizeHint(const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
  // As wide as it is in bold, so that nothing moves when the selection does.
  QFont bold = style::figures(option.font);
  bold.setBold(true);
  const QFontMetrics metrics(bold);
  const int extra = index.column() == ProbeTableModel::TitleColumn ? chipWidth + 6 : 2 * padding;
  return {metrics.horizontalAdvance(index.data().toString()) + extra, metrics.height() + 5};
}

}  // namespace umbra
