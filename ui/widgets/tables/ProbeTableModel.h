// The rows of ProbeTable: one per technique of a probe.
#pragma once

#include <QAbstractTableModel>
#include <QColor>
#include <QStyledItemDelegate>
#include <optional>
#include <vector>

#include "analysis/probe/Probe.h"

namespace umbra {

// A second truth below the techniques: the region's visibility by rays through every texel.
struct RayTracedRow {
  std::optional<double> visibility;  // none: not known yet
};

class ProbeTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    TitleColumn,
    ValueColumn,
    GpuColumn,
    ErrorColumn,
    BytesColumn,
    BarColumn,
    ColumnCount
  };
  enum Role { IdRole = Qt::UserRole, ColourRole, ErrorRole };

  using QAbstractTableModel::QAbstractTableModel;

  // Rows are in the order of the lists. Techniques that the storage format cannot hold stand among
  // the others, show a dash, say why, and cannot be chosen. Where the techniques are the same, the
  // rows stay, so that a selection survives a moving probe. `format` is that of the map's textures;
  // without one nothing is stored, and no bytes are shown.
  void setProbe(const Probe& probe, const std::optional<RayTracedRow>& rays = {},
                std::optional<StorageFormat> format = {});
  void clear();
  bool hasGpuValues() const;
  bool hasBytes() const;
  int rowOf(const QString& id) const;  // −1 where there is none
  QString asText() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    QString id, title, citation;
    QColor colour;
    double visibility = 0.0, error = 0.0;
    std::optional<double> gpu;
    std::optional<double> bytes;  // per texel, of the channels
    bool pending = false;         // the figures are not known yet
    QString refusal;              // why there are no figures; empty where there are
    int order = 0;
  };

  static Row rayTracedRow(const RayTracedRow& rays, double reference);

  std::vector<Row> rows_;
};

// A colour chip before the title, the error as a bar left or right of zero.
class ProbeTableDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  static constexpr int chipWidth = 18;
  static constexpr int padding = 5;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace umbra
