#include "ui/widgets/tables/SavedProbesModel.h"

#include <algorithm>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

const QString absent = QStringLiteral("–");

}  // namespace

void SavedProbesModel::setTechniques(std::vector<TechniqueColumn> techniques,
                                     const QString& selected) {
  const bool same =
      std::equal(techniques.begin(), techniques.end(), techniques_.begin(), techniques_.end(),
                 [](const auto& a, const auto& b) { return a.id == b.id; });
  if (!same) beginResetModel();
  techniques_ = std::move(techniques);
  selected_ = selected;
  if (!same) return endResetModel();
  emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
  emitFiguresChanged();
}

void SavedProbesModel::setRows(std::vector<SavedProbeRow> rows) {
  const bool same = rows.size() == rows_.size();
  if (!same) beginResetModel();
  std::swap(rows_, rows);
  if (!same) return endResetModel();
  // A name that is being edited is left alone where it has not changed.
  for (int row = 0; row < rowCount(); ++row) {
    const SavedProbeRow &before = rows[std::size_t(row)], &after = rows_[std::size_t(row)];
    const bool named = before.name == after.name && before.note == after.note;
    emit dataChanged(index(row, named ? TruthColumn : NameColumn), index(row, columnCount() - 1));
  }
}

void SavedProbesModel::setErrorsShown(bool shown) {
  errorsShown_ = shown;
  emitFiguresChanged();
}

void SavedProbesModel::emitFiguresChanged() {
  if (rows_.empty()) return;
  emit dataChanged(index(0, TruthColumn), index(rowCount() - 1, columnCount() - 1));
}

const TechniqueColumn* SavedProbesModel::techniqueAt(int column) const {
  const int place = column - FirstTechnique;
  return place >= 0 && place < int(techniques_.size()) ? &techniques_[std::size_t(place)] : nullptr;
}

int SavedProbesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(rows_.size());
}

int SavedProbesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : FirstTechnique + int(techniques_.size());
}

Qt::ItemFlags SavedProbesModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.column() == NameColumn ? flags | Qt::ItemIsEditable : flags;
}

const SheetFigures::Entry* SavedProbesModel::entryAt(const QModelIndex& index) const {
  const TechniqueColumn* technique = techniqueAt(index.column());
  const auto& figures = rows_[std::size_t(index.row())].figures;
  return technique && figures ? figures->of(technique->id.toStdString()) : nullptr;
}

QString SavedProbesModel::textAt(const QModelIndex& index) const {
  const SavedProbeRow& row = rows_[std::size_t(index.row())];
  if (index.column() == NameColumn) return row.name;
  if (!row.figures) return absent;
  if (index.column() == TruthColumn) return QString::number(row.figures->reference, 'f', 3);
  const SheetFigures::Entry* entry = entryAt(index);
  if (!entry) return absent;
  return errorsShown_ ? style::signedFigure(entry->error)
                      : QString::number(entry->visibility, 'f', 3);
}

QString SavedProbesModel::hintAt(const QModelIndex& index) const {
  const SavedProbeRow& row = rows_[std::size_t(index.row())];
  if (index.column() == NameColumn) {
    const QString note = row.note.isEmpty() ? QString() : QStringLiteral("\n") + row.note;
    return row.name + QStringLiteral("\n") + row.place + note;
  }
  if (!row.figures) return row.note;
  if (index.column() == TruthColumn)
    return tr("%1: exact percentage-closer filtering, receiver depth %2")
        .arg(row.name, style::figure(row.figures->receiver));
  const TechniqueColumn& technique = *techniqueAt(index.column());
  const SheetFigures::Entry* entry = entryAt(index);
  if (!entry) return technique.title + QStringLiteral(": ") + technique.refusal;
  return tr("%1 at %2: lit %3, reference %4, error %5")
      .arg(technique.title, row.name, QString::number(entry->visibility, 'f', 3),
           QString::number(row.figures->reference, 'f', 3), style::signedFigure(entry->error));
}

QVariant SavedProbesModel::data(const QModelIndex& index, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      return textAt(index);
    case Qt::EditRole:
      return rows_[std::size_t(index.row())].name;
    case Qt::ToolTipRole:
      return hintAt(index);
    case NoteRole:
      return rows_[std::size_t(index.row())].note;
    case ErrorRole: {
      const SheetFigures::Entry* entry = entryAt(index);
      return entry ? QVariant(entry->error) : QVariant();
    }
    case MarkedRole: {
      const TechniqueColumn* technique = techniqueAt(index.column());
      return technique && technique->id == selected_;
    }
    default:
      return {};
  }
}

QVariant SavedProbesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const TechniqueColumn* technique = techniqueAt(section);
  const bool marked = technique && technique->id == selected_;
  switch (role) {
    case Qt::DisplayRole:
      return technique ? technique->brief : section == NameColumn ? tr("Probe") : tr("Reference");
    case Qt::ToolTipRole:
      return technique                ? technique->title
             : section == TruthColumn ? tr("Exact percentage-closer filtering")
                                      : tr("Click a row to go there, double-click to rename");
    case Qt::TextAlignmentRole:
      return int((section == NameColumn ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      return marked ? style::accent : style::muted;
    case Qt::FontRole: {
      QFont font;
      font.setBold(marked);
      return font;
    }
    default:
      return {};
  }
}

bool SavedProbesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || index.column() != NameColumn) return false;
  emit renamed(index.row(), value.toString());
  return true;
}

}  // namespace umbra
