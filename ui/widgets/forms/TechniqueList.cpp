#include "ui/widgets/forms/TechniqueList.h"

#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

enum Role { IdRole = Qt::UserRole, ColourRole, KeyRole, AboutRole, RefusedRole };

class TechniqueDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const QColor colour = index.data(ColourRole).value<QColor>();
    const bool selected = option.state & QStyle::State_Selected;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (selected || option.state & QStyle::State_MouseOver)
      painter->fillRect(option.rect, selected ? style::tint(colour) : style::ground);

    const QRectF row = option.rect;
    painter->setPen(Qt::NoPen);
    const bool refused = index.data(RefusedRole).toBool();
    painter->setBrush(refused ? style::tint(colour) : colour);
    painter->drawRoundedRect(QRectF(row.left() + 4, row.center().y() - 4, 9, 9), 2, 2);

    QFont font = option.font;
    font.setBold(selected);
    painter->setFont(font);
    const int digitWidth = 18;
    const QRect title = option.rect.adjusted(20, 0, -digitWidth - 4, 0);
    painter->setPen(refused ? style::muted : style::ink);
    painter->drawText(
        title, Qt::AlignVCenter | Qt::AlignLeft,
        QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, title.width()));
    painter->setFont(style::figures(option.font));
    painter->setPen(style::muted);
    painter->drawText(option.rect.adjusted(0, 0, -4, 0), Qt::AlignVCenter | Qt::AlignRight,
                      index.data(KeyRole).toString());
    painter->restore();
  }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {120, option.fontMetrics.height() + 6};
  }
};

QString toolTipOf(const TechniqueInfo& info) {
  return QString("<p style='white-space:pre-wrap'><b>%1</b><br>%2</p><p>%3</p><p>%4</p>")
      .arg(style::text(info.title).toHtmlEscaped(), style::text(info.summary).toHtmlEscaped(),
           style::text(info.formula).toHtmlEscaped(), style::text(info.citation).toHtmlEscaped());
}

}  // namespace

QString techniqueKey(int place) {
  return place <= 9 ? QString::number(place) : place == 10 ? QStringLiteral("M") : QString();
}

TechniqueList::TechniqueList(QWidget* parent)
    : Card(tr("Technique"), parent), list_(new QListWidget) {
  list_->setItemDelegate(new TechniqueDelegate(list_));
  list_->setMouseTracking(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  body()->addWidget(list_);
  body()->addStretch();
  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item) emit techniqueChosen(item->data(IdRole).toString());
  });
}

void TechniqueList::setTechniques(const std::vector<const Technique*>& techniques) {
  const QString before = current();
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const Technique* technique : techniques) {
    const TechniqueInfo& info = technique->info();
    auto* item = new QListWidgetItem(style::text(info.title), list_);
    item->setData(IdRole, style::text(info.id));
    item->setData(ColourRole, QColor(style::text(info.colour)));
    item->setData(KeyRole, techniqueKey(list_->row(item)));
    item->setData(AboutRole, toolTipOf(info));
    item->setToolTip(toolTipOf(info));
  }
  setCurrent(before);
  list_->setFixedHeight(list_->count() == 0 ? 0 : list_->count() * list_->sizeHintForRow(0) + 2);
}

void TechniqueList::setCurrent(const QString& id) {
  const QSignalBlocker quiet(list_);
  QListWidgetItem* found = nullptr;
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(IdRole) == id) found = list_->item(row);
  list_->setCurrentItem(found);
}

void TechniqueList::setRefusals(const QMap<QString, QString>& reasons) {
  const QSignalBlocker quiet(list_);
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    const QString reason = reasons.value(item->data(IdRole).toString());
    item->setData(RefusedRole, !reason.isEmpty());
    item->setToolTip(reason.isEmpty() ? item->data(AboutRole).toString() : reason);
    // The current technique stays choosable: a session that was read from a file may combine it
    // with what cannot be chosen here.
    const bool choosable = reason.isEmpty() || item == list_->currentItem();
    item->setFlags(choosable ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::NoItemFlags);
  }
}

QString TechniqueList::current() const {
  const QListWidgetItem* item = list_->currentItem();
  return item ? item->data(IdRole).toString() : QString();
}

}  // namespace umbra
