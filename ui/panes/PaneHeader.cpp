#include "ui/panes/PaneHeader.h"

#include <QComboBox>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QStandardItemModel>
#include <QToolButton>
#include <string_view>

#include "ui/picture/ProbeReport.h"
#include "ui/widgets/base/ElidedLabel.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/base/TechniqueTitle.h"

namespace umbra {
namespace {

constexpr int chipSide = 9;  // logical pixels, as in the list of techniques
constexpr int boxRoom = 52;  // beside a technique's name: its chip, the arrow, the frame
constexpr int headerMargin = 6;

QPixmap chip(const QColor& colour) {
  QPixmap pixmap(chipSide, chipSide);
  pixmap.fill(colour);
  return pixmap;
}

}  // namespace

PaneHeader::PaneHeader(const std::vector<const Technique*>& techniques, QMenu& menu,
                       QWidget* parent)
    : QWidget(parent),
      layout_(new QGridLayout(this)),
      box_(new QComboBox),
      differences_(new ElidedLabel),
      error_(new QLabel),
      menuButton_(new QToolButton),
      menu_(menu) {
  // Panes are equally wide whatever their labels say. Otherwise a label that is laid out for its
  // width would change that width, and the width of the labels beside it.
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout_->setContentsMargins(headerMargin, 3, headerMargin, 3);
  layout_->setHorizontalSpacing(6);
  layout_->setVerticalSpacing(1);
  for (const Technique* technique : techniques) {
    const TechniqueInfo& info = technique->info();
    box_->addItem(chip(QColor(style::text(info.colour))), shortTitle(*technique),
                  style::text(info.id));
    titles_ << style::text(info.title);
  }
  setRefusals({});
  // Its text may be cut, so that six panes fit side by side on a small screen.
  box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box_->setMinimumContentsLength(5);
  box_->setIconSize({chipSide, chipSide});
  box_->setFocusPolicy(Qt::TabFocus);
  box_->setToolTip(tr("The technique of this pane"));
  differences_->setObjectName("paneDifferences");
  error_->setFont(style::figures(error_->font()));
  error_->setObjectName("paneError");
  menuButton_->setText(QStringLiteral("⋯"));
  menuButton_->setAutoRaise(true);
  menuButton_->setPopupMode(QToolButton::InstantPopup);
  menuButton_->setMenu(&menu_);
  menuButton_->setFocusPolicy(Qt::TabFocus);
  menuButton_->setToolTip(tr("Duplicate, share settings, close …"));
  menuButton_->setStyleSheet(
      "QToolButton { border: none; padding: 0 3px; }"
      "QToolButton::menu-indicator { image: none; width: 0; }");
  layout_->addWidget(box_, 0, 0);
  layout_->addWidget(error_, 0, 2);
  layout_->addWidget(menuButton_, 0, 3);
  layout_->addWidget(differences_, 1, 0, 1, 4);
  layout_->setColumnStretch(0, 1);
  differences_->hide();
  connect(box_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit techniqueChosen(technique()); });
}

// The differences stand beside the technique, or beneath it where there is too little room.
void PaneHeader::place() {
  const QString text = differences_->text();
  const QFontMetrics metrics = fontMetrics();
  const int technique = metrics.horizontalAdvance(box_->currentText()) + boxRoom;
  const int others = metrics.horizontalAdvance("+0.000") + menuButton_->sizeHint().width() +
                     3 * layout_->horizontalSpacing() + 2 * headerMargin;
  const bool fits = technique + metrics.horizontalAdvance(text) + others <= width();
  const Place wanted = text.isEmpty() ? Place::Nowhere : fits ? Place::Beside : Place::Beneath;
  box_->setMinimumWidth(wanted == Place::Beside ? technique : 0);
  if (wanted == place_) return;
  place_ = wanted;
  layout_->removeWidget(differences_);
  if (wanted == Place::Beside)
    layout_->addWidget(differences_, 0, 1);
  else
    layout_->addWidget(differences_, 1, 0, 1, 4);
  layout_->setColumnStretch(0, wanted == Place::Beside ? 0 : 1);
  layout_->setColumnStretch(1, wanted == Place::Beside ? 1 : 0);
  differences_->setVisible(wanted != Place::Nowhere);
}

void PaneHeader::setTechnique(const QString& id) {
  box_->setCurrentIndex(box_->findData(id));
}

void PaneHeader::setRefusals(const QMap<QString, QString>& refusals) {
  auto* items = qobject_cast<QStandardItemModel*>(box_->model());
  for (int row = 0; row < items->rowCount(); ++row) {
    QStandardItem* item = items->item(row);
    const QString reason = refusals.value(item->data(Qt::UserRole).toString());
    item->setEnabled(reason.isEmpty());
    item->setToolTip(reason.isEmpty() ? titles_[row] : reason);
  }
}

QString PaneHeader::technique() const {
  return box_->currentData().toString();
}

void PaneHeader::setDifferences(const QString& text) {
  differences_->setText(text);
  place();
}

QString PaneHeader::differences() const {
  return differences_->text();
}

void PaneHeader::setLinked(bool linked) {
  linked_ = linked;
  explain();
}

void PaneHeader::explain() {
  const QString settings = linked_ ? tr("Shares its settings with the other panes that do")
                                   : tr("Has settings of its own");
  setToolTip(active_ ? settings : tr("%1. Click to bring them to the controls").arg(settings));
}

void PaneHeader::setActive(bool active) {
  setCursor(active ? Qt::ArrowCursor : Qt::PointingHandCursor);
  active_ = active;
  QFont font = box_->font();
  font.setBold(active);
  box_->setFont(font);
  explain();
  update();
}

void PaneHeader::setError(const std::optional<double>& error) {
  const bool wrong = error && std::string_view(verdictOf(*error)) != verdictOf(0.0);
  error_->setText(error ? style::signedFigure(*error) : QString());
  error_->setToolTip(error ? tr("Error at the probe: %1").arg(tr(verdictOf(*error))) : QString());
  error_->setStyleSheet(QString("color: %1").arg((wrong ? style::error : style::muted).name()));
}

QString PaneHeader::errorText() const {
  return error_->text();
}

void PaneHeader::resizeEvent(QResizeEvent*) {
  place();
}

void PaneHeader::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit chosen();
}

void PaneHeader::contextMenuEvent(QContextMenuEvent* event) {
  menu_.popup(event->globalPos());
}

void PaneHeader::paintEvent(QPaintEvent*) {
  if (!active_) return;
  QPainter painter(this);
  painter.fillRect(rect(), style::tint(style::accent));
  painter.fillRect(QRect(0, height() - 2, width(), 2), style::accent);
}

}  // namespace umbra
