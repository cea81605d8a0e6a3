#include "ui/widgets/tables/ProbeTable.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/widgets/base/Style.h"
#include "ui/widgets/tables/PlainTable.h"
#include "ui/widgets/tables/ProbeTableModel.h"

namespace umbra {
namespace {

constexpr int narrowestBar = 36;
constexpr int widestBar = 160;

}  // namespace

ProbeTable::ProbeTable(QWidget* parent)
    : Card(tr("All techniques at this pixel"), parent),
      model_(new ProbeTableModel(this)),
      view_(new QTableView),
      hint_(new QLabel) {
  view_->setModel(model_);
  view_->setItemDelegate(new ProbeTableDelegate(view_));
  makePlain(*view_, style::muted);
  view_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  body()->addWidget(view_);
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  QPalette palette = hint_->palette();
  palette.setColor(QPalette::WindowText, style::muted);
  hint_->setPalette(palette);
  body()->addWidget(hint_, 1);

  auto* copyButton = new QToolButton;
  copyButton->setText(tr("Copy"));
  copyButton->setToolTip(tr("Copy the table as text, tab separated"));
  copyButton->setAutoRaise(true);
  addToHeader(copyButton);
  connect(copyButton, &QToolButton::clicked, this, &ProbeTable::copy);
  auto* copyAction = new QAction(tr("Copy table"), view_);
  view_->addAction(copyAction);
  view_->setContextMenuPolicy(Qt::ActionsContextMenu);
  connect(copyAction, &QAction::triggered, this, &ProbeTable::copy);

  showHint(true);
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            const QString id = current.data(ProbeTableModel::IdRole).toString();
            if (!quiet_ && !id.isEmpty()) emit techniqueChosen(id);
          });
}

void ProbeTable::setProbe(const Probe& probe, const QString& selected,
                          const std::optional<RayTracedRow>& rays,
                          std::optional<StorageFormat> format) {
  model_->setProbe(probe, rays, format);
  showHint(false);
  setSelected(selected);
  arrangeColumns();
}

// The selection model's own signals must go on: the view repaints by them.
void ProbeTable::setSelected(const QString& id) {
  quiet_ = true;
  const int row = model_->rowOf(id);
  if (row >= 0)
    view_->setCurrentIndex(model_->index(row, 0));
  else
    view_->clearSelection();
  quiet_ = false;
}

void ProbeTable::clear(const QString& hint) {
  model_->clear();
  hint_->setText(hint.isEmpty()
                     ? tr("Point at a shadow: what every technique makes of it appears here.")
                     : hint);
  showHint(true);
}

void ProbeTable::showHint(bool shown) {
  hint_->setVisible(shown);
  view_->setVisible(!shown);
}

QString ProbeTable::asText() const {
  return model_->asText();
}

void ProbeTable::copy() const {
  QGuiApplication::clipboard()->setText(asText());
}

void ProbeTable::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  arrangeColumns();
}

void ProbeTable::showEvent(QShowEvent* event) {
  Card::showEvent(event);
  arrangeColumns();
}

// Titles and figures get their room first, and the bar takes what is left. Where that is too
// little, the column of bytes is left out, then the GPU's, then the bar.
void ProbeTable::arrangeColumns() {
  using Model = ProbeTableModel;
  view_->resizeRowsToContents();
  view_->setColumnHidden(Model::GpuColumn, !model_->hasGpuValues());
  view_->setColumnHidden(Model::BytesColumn, !model_->hasBytes());
  view_->setColumnHidden(Model::BarColumn, false);
  int rest = view_->viewport()->width();
  for (int column : {Model::TitleColumn, Model::ValueColumn, Model::GpuColumn, Model::ErrorColumn,
                     Model::BytesColumn}) {
    if (view_->isColumnHidden(column)) continue;
    view_->resizeColumnToContents(column);
    rest -= view_->columnWidth(column);
  }
  for (int column : {Model::BytesColumn, Model::GpuColumn}) {
    if (rest >= narrowestBar || view_->isColumnHidden(column)) continue;
    rest += view_->columnWidth(column);
    view_->setColumnHidden(column, true);
  }
  if (rest < narrowestBar) {
    view_->setColumnHidden(Model::BarColumn, true);
    view_->setColumnWidth(Model::TitleColumn, view_->columnWidth(Model::TitleColumn) + rest);
  } else {
    view_->setColumnWidth(Model::BarColumn, std::min(rest, widestBar));
    view_->setColumnWidth(Model::TitleColumn,
                          view_->columnWidth(Model::TitleColumn) + std::max(0, rest - widestBar));
  }
}

}  // namespace umbra
