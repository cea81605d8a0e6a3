#include "ui/probe/SavedProbesPane.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "datasets/session/PaneChoice.h"
#include "ui/probe/Prober.h"
#include "ui/probe/SavedProbes.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/base/TechniqueTitle.h"
#include "ui/widgets/tables/PlainTable.h"
#include "ui/widgets/tables/SavedProbesModel.h"

namespace umbra {
namespace {

// "Layered power CDF" and "Hard shadow map" over a narrow column of figures.
QString inTwoLines(QString title) {
  title.remove(QStringLiteral(" shadow map"));
  const int space = int(title.indexOf(' '));
  return space < 0 ? title : title.replace(space, 1, '\n');
}

}  // namespace

SavedProbesPane::SavedProbesPane(SavedProbes& probes, SessionController& controller, Prober& prober,
                                 QWidget* parent)
    : Card(tr("Saved probes"), parent),
      probes_(probes),
      controller_(controller),
      prober_(prober),
      model_(new SavedProbesModel(this)),
      view_(new QTableView),
      hint_(new QLabel),
      save_(new QToolButton),
      errors_(new QToolButton),
      copy_(new QToolButton) {
  makeTable();
  makeHeader();
  makeMenu();
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  QPalette palette = hint_->palette();
  palette.setColor(QPalette::WindowText, style::muted);
  hint_->setPalette(palette);
  body()->addWidget(hint_, 1);
  connect(&probes_, &SavedProbes::changed, this, &SavedProbesPane::refresh);
  connect(&prober_, &Prober::reported, this, [this] {
    save_->setEnabled(probes_.canSave());
    if (hint_->text() != hint()) refresh();  // a veil came or went
  });
  refresh();
}

void SavedProbesPane::makeTable() {
  view_->setModel(model_);
  view_->setItemDelegate(new SavedProbesDelegate(view_));
  makePlain(*view_, {});
  view_->setEditTriggers(QAbstractItemView::DoubleClicked);
  view_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  view_->setTabKeyNavigation(false);
  QHeaderView* header = view_->horizontalHeader();
  header->setSectionsClickable(true);
  view_->setCornerWidget(new QWidget);  // the style draws a grip there
  body()->addWidget(view_, 1);
  const auto go = [this](const QModelIndex& index) { probes_.goTo(index.row()); };
  connect(view_, &QTableView::clicked, this, go);
  connect(view_, &QTableView::activated, this, go);
  connect(header, &QHeaderView::sectionClicked, this, [this](int section) {
    const TechniqueColumn* technique = model_->techniqueAt(section);
    if (!technique || !technique->refusal.isEmpty()) return;
    controller_.editPanes(tr("Choose technique"), [id = technique->id](Workspace& workspace) {
      chooseTechnique(workspace, id.toStdString());
    });
  });
  // Once the editor has closed: the rows may change by it.
  connect(
      model_, &SavedProbesModel::renamed, this,
      [this](int row, const QString& name) { probes_.rename(row, name); }, Qt::QueuedConnection);
}

void SavedProbesPane::makeHeader() {
  const auto button = [this](QToolButton* made, const QString& text, const QString& hint) {
    made->setText(text);
    made->setToolTip(hint);
    made->setAutoRaise(true);
    addToHeader(made);
  };
  button(save_, tr("Save probe"), tr("Add the present probe to this table (K)"));
  button(errors_, tr("Errors"), tr("Show errors in place of visibilities"));
  button(copy_, tr("Copy"), tr("Copy the table as text, tab separated"));
  errors_->setCheckable(true);
  errors_->setStyleSheet(QString("QToolButton:checked { background: %1; color: %2; }")
                             .arg(style::tint(style::accent).name(), style::accent.name()));
  connect(save_, &QToolButton::clicked, &probes_, &SavedProbes::save);
  connect(errors_, &QToolButton::toggled, this,
          [this](bool shown) { model_->setErrorsShown(shown); });
  connect(copy_, &QToolButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(asText('\t')); });
}

void SavedProbesPane::makeMenu() {
  const auto add = [this](const QString& text, auto run) {
    auto* action = new QAction(text, view_);
    view_->addAction(action);
    connect(action, &QAction::triggered, this, run);
    return action;
  };
  add(tr("Save probe"), [this] { probes_.save(); });
  add(tr("Rename probe"), [this] { editName(view_->currentIndex().row()); });
  QAction* drop = add(tr("Delete probe"), [this] {
    const QModelIndex index = view_->currentIndex();
    if (index.isValid()) probes_.drop(index.row());
  });
  drop->setShortcut(QKeySequence::Delete);
  drop->setShortcutContext(Qt::WidgetShortcut);
  add(tr("Copy table"), [this] { QGuiApplication::clipboard()->setText(asText('\t')); });
  view_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void SavedProbesPane::editName(int row) {
  const QModelIndex index = model_->index(row, SavedProbesModel::NameColumn);
  if (index.isValid()) view_->edit(index);
}

QString SavedProbesPane::asText(char separator) const {
  const bool shown = prober_.veil().isEmpty() && !probes_.rows().empty();
  return shown ? probes_.text(separator) : QString();
}

QString SavedProbesPane::hint() const {
  if (!prober_.veil().isEmpty()) return prober_.veil();
  return tr(
      "Point at a shadow and press K to save the place here, under a name: what every "
      "technique makes of all saved places stands side by side.");
}

void SavedProbesPane::refresh() {
  const bool shown = !probes_.rows().empty() && prober_.veil().isEmpty();
  hint_->setText(hint());
  hint_->setVisible(!shown);
  view_->setVisible(shown);
  save_->setEnabled(probes_.canSave());
  for (QToolButton* button : {errors_, copy_}) button->setEnabled(shown);

  const QMap<QString, QString> refusals = controller_.refusals();
  std::vector<TechniqueColumn> techniques;
  for (const auto& technique : controller_.techniques()) {
    const QString id = style::text(technique->info().id);
    techniques.push_back({id, inTwoLines(shortTitle(*technique)),
                          style::text(technique->info().title), refusals.value(id)});
  }
  model_->setTechniques(std::move(techniques), style::text(controller_.session().technique));
  const Content& content = controller_.document().content;
  std::vector<SavedProbeRow> rows;
  for (const SavedProbes::Row& row : probes_.rows()) {
    const NamedProbe& probe = row.probe;
    const Pixel texel = texelInFile(content, probe.texel.value_or(Pixel{}));
    const QString place =
        probe.point ? tr("at %1, %2, %3 in the scene")
                          .arg(style::figure(probe.point->x()), style::figure(probe.point->y()),
                               style::figure(probe.point->z()))
                    : tr("texel %1, %2").arg(texel.x).arg(texel.y);
    rows.push_back(
        {style::text(probe.name), place, row.figures, row.hidden ? tr("hidden") : row.reason});
  }
  model_->setRows(std::move(rows));
  arrangeColumns();
  select(probes_.current());
}

// A row is brought into view when it becomes the current one, not whenever something is read.
void SavedProbesPane::select(int row) {
  if (row < 0) {
    view_->clearSelection();
  } else if (row != selected_ || !view_->selectionModel()->isRowSelected(row, {})) {
    view_->selectRow(row);
    view_->scrollTo(model_->index(row, SavedProbesModel::NameColumn));
  }
  selected_ = row;
}

void SavedProbesPane::arrangeColumns() {
  view_->resizeColumnsToContents();
  view_->resizeRowsToContents();
}

}  // namespace umbra
