#include <QPainter>
#include <QWidget>
#include <algorithm>

#include "filters/gpu/ViewColours.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/tables/SavedProbesModel.h"

namespace umbra {
namespace {

constexpr int discSpace = 24;  // before a name
constexpr int padding = 4;
constexpr int widestCell = 190;

QColor colourOf(double error) {
  const ViewColour colour = colourOfError(error);
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

bool isDark(const QColor& colour) {
  return qGray(colour.rgb()) < 140;
}

}  // namespace

void SavedProbesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                                const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const bool selected = option.state & QStyle::State_Selected;
  if (selected)
    painter->fillRect(option.rect, style::tint(style::probe));
  else if (index.data(SavedProbesModel::MarkedRole).toBool())
    painter->fillRect(option.rect, style::tint(style::accent));
  if (index.column() == SavedProbesModel::NameColumn)
    paintName(*painter, option, index);
  else
    paintFigure(*painter, option, index);
  painter->setRenderHint(QPainter::Antialiasing, false);
  painter->setPen(style::border);
  painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
  painter->restore();
}

void SavedProbesDelegate::paintName(QPainter& painter, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
  const QRectF disc(option.rect.left() + 3.0, option.rect.center().y() - 7.5, 16.0, 16.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(style::probe);
  painter.drawEllipse(disc);
  QFont small = style::figures(option.font);
  small.setPointSizeF(small.pointSizeF() * 0.82);
  small.setBold(true);
  painter.setFont(small);
  painter.setPen(style::ink);
  painter.drawText(disc, Qt::AlignCenter, QString::number(index.row() + 1));

  QFont font = option.font;
  font.setBold(option.state & QStyle::State_Selected);
  const QRect room = option.rect.adjusted(discSpace, 0, -2, 0);
  const QString note = index.data(SavedProbesModel::NoteRole).toString();
  const QFontMetrics metrics(font), noteMetrics(option.font);
  const int noteWidth = note.isEmpty() ? 0 : noteMetrics.horizontalAdvance(note) + 8;
  const int nameWidth = std::max(room.width() - noteWidth, room.width() / 2);
  const QString name = metrics.elidedText(index.data().toString(), Qt::ElideRight, nameWidth);
  painter.setFont(font);
  painter.setPen(style::ink);
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, name);
  if (note.isEmpty()) return;
  painter.setFont(option.font);
  painter.setPen(style::muted);
  const QRect rest = room.adjusted(metrics.horizontalAdvance(name) + 8, 0, 0, 0);
  painter.drawText(rest, Qt::AlignVCenter | Qt::AlignLeft,
                   noteMetrics.elidedText(note, Qt::ElideRight, rest.width()));
}

void SavedProbesDelegate::paintFigure(QPainter& painter, const QStyleOptionViewItem& option,
                                      const QModelIndex& index) const {
  const QVariant error = index.data(SavedProbesModel::ErrorRole);
  QColor ink = style::ink;
  if (error.isValid()) {
    const QColor ground = colourOf(error.toDouble());
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(2.0, 2.0, -2.0, -3.0), 3.0, 3.0);
    if (isDark(ground)) ink = Qt::white;
  }
  QFont font = style::figures(option.font);
  font.setBold(option.state & QStyle::State_Selected);
  painter.setFont(font);
  painter.setPen(ink);
  painter.drawText(option.rect, Qt::AlignCenter, index.data().toString());
}

QSize SavedProbesDelegate::sizeHint(const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
  QFont bold = style::figures(option.font);  // nothing moves when the selection does
  bold.setBold(true);
  const QFontMetrics metrics(bold);
  int width = metrics.horizontalAdvance(index.data().toString()) + 2 * padding;
  if (index.column() == SavedProbesModel::NameColumn) {
    const QString note = index.data(SavedProbesModel::NoteRole).toString();
    if (!note.isEmpty()) width += metrics.horizontalAdvance(note) + 8;
    width = std::min(width + discSpace, widestCell);
  }
  return {width, metrics.height() + 8};
}

void SavedProbesDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                               const QModelIndex&) const {
  editor->setGeometry(option.rect.adjusted(discSpace - 4, 0, 0, -1));
}

}  // namespace umbra
