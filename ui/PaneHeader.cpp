#include "ui/PaneHeader.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <string_view>

#include "ui/ProbeReport.h"
#include "ui/widgets/Style.h"

namespace umbra {
namespace {

constexpr int chipSide = 9;  // logical pixels, as in the list of techniques

QPixmap chip(const QColor& colour) {
  QPixmap pixmap(chipSide, chipSide);
  pixmap.fill(colour);
  return pixmap;
}

}  // namespace

QString shortTitle(const Technique& technique) {
  const QString title = style::text(technique.info().title);
  const int open = title.lastIndexOf('('), close = title.lastIndexOf(')');
  return open >= 0 && close > open ? title.mid(open + 1, close - open - 1) : title;
}

PaneHeader::PaneHeader(const std::vector<const Technique*>& techniques, QWidget* parent)
    : QWidget(parent), box_(new QComboBox), error_(new QLabel) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 3, 6, 3);
  layout->setSpacing(6);
  for (const Technique* technique : techniques) {
    const TechniqueInfo& info = technique->info();
    box_->addItem(chip(QColor(style::text(info.colour))), shortTitle(*technique),
                  style::text(info.id));
    box_->setItemData(box_->count() - 1, style::text(info.title), Qt::ToolTipRole);
  }
  // Its text may be cut, so that six panes fit side by side on a small screen.
  box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box_->setMinimumContentsLength(5);
  box_->setIconSize({chipSide, chipSide});
  box_->setFocusPolicy(Qt::TabFocus);
  box_->setToolTip(tr("The technique of this pane"));
  error_->setFont(style::figures(error_->font()));
  error_->setObjectName("paneError");
  layout->addWidget(box_, 1);
  layout->addWidget(error_);
  connect(box_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit techniqueChosen(technique()); });
}

void PaneHeader::setTechnique(const QString& id) {
  box_->setCurrentIndex(box_->findData(id));
}

QString PaneHeader::technique() const {
  return box_->currentData().toString();
}

void PaneHeader::setActive(bool active) {
  active_ = active;
  QFont font = box_->font();
  font.setBold(active);
  box_->setFont(font);
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

void PaneHeader::paintEvent(QPaintEvent*) {
  if (!active_) return;
  QPainter painter(this);
  painter.fillRect(QRect(0, height() - 2, width(), 2), style::accent);
}

}  // namespace umbra
