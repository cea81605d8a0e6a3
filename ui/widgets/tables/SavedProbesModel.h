// The rows of SavedProbesPane: a probe each, with a column for every technique.
#pragma once

#include <QAbstractTableModel>
#include <QColor>
#include <QStyledItemDelegate>
#include <optional>
#include <vector>

#include "analysis/probe/ProbeSheet.h"

namespace umbra {

struct SavedProbeRow {
  QString name;
  QString place;  // where it is, for the tooltip
  std::optional<SheetFigures> figures;
  QString note;  // beside the name: why there are no figures, or that it is hidden
};

struct TechniqueColumn {
  QString id, brief, title;
  QString refusal;  // why it has no figures with the present settings; empty where it has
};

class SavedProbesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { NameColumn, TruthColumn, FirstTechnique };
  enum Role { NoteRole = Qt::UserRole, ErrorRole, MarkedRole };

  using QAbstractTableModel::QAbstractTableModel;

  void setTechniques(std::vector<TechniqueColumn> techniques, const QString& selected);
  void setRows(std::vector<SavedProbeRow> rows);
  // Errors in place of visibilities.
  void setErrorsShown(bool shown);

  const TechniqueColumn* techniqueAt(int column) const;  // null for the first two

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  // Takes a new name of a probe: it emits `renamed`, and whoever listens changes the session.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 signals:
  void renamed(int row, const QString& name);

 private:
  const SheetFigures::Entry* entryAt(const QModelIndex& index) const;
  void emitFiguresChanged();
  QString textAt(const QModelIndex& index) const;
  QString hintAt(const QModelIndex& index) const;

  std::vector<TechniqueColumn> techniques_;
  std::vector<SavedProbeRow> rows_;
  QString selected_;
  bool errorsShown_ = false;
};

// The probe's number before its name, figures on the colours of the error view.
class SavedProbesDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;

 private:
  void paintName(QPainter& painter, const QStyleOptionViewItem& option,
                 const QModelIndex& index) const;
  void paintFigure(QPainter& painter, const QStyleOptionViewItem& option,
                   const QModelIndex& index) const;
};

}  // namespace umbra
