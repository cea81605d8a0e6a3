#include "ui/widgets/tables/ProbeTableModel.h"

#include <algorithm>
#include <limits>

#include "analysis/cost/TechniqueCost.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/technique/VisibleError.h"
#include "ui/widgets/base/Style.h"

namespace umbra {

// The row is no technique: it has no id, and cannot be chosen.
ProbeTableModel::Row ProbeTableModel::rayTracedRow(const RayTracedRow& rays, double reference) {
  Row row;
  row.title = tr("Rays, without a map");
  row.citation =
      tr("What exact percentage-closer filtering differs from it is the shadow map's "
         "error; what a technique differs from percentage-closer filtering is the "
         "filter's.");
  row.colour = style::ink;
  row.pending = !rays.visibility;
  if (rays.visibility) {
    row.visibility = *rays.visibility;
    row.error = row.visibility - reference;
  }
  row.order = std::numeric_limits<int>::max();
  return row;
}

void ProbeTableModel::setProbe(const Probe& probe, const std::optional<RayTracedRow>& rays,
                               std::optional<StorageFormat> format) {
  std::vector<Row> rows;
  const auto add = [&rows](const TechniqueInfo& info) -> Row& {
    rows.push_back({style::text(info.id), style::text(info.title), style::text(info.citation),
                    QColor(style::text(info.colour))});
    rows.back().order = info.order;
    return rows.back();
  };
  for (const TechniqueResult& result : probe.techniques) {
    Row& row = add(result.technique->info());
    row.visibility = result.visibility;
    row.error = result.error;
    row.gpu = result.gpu;
    if (format) row.bytes = bytesStoredPerTexel(*result.technique, *format);
  }
  for (const RefusedTechnique& refused : probe.refused)
    add(refused.technique->info()).refusal = style::text(refused.reason);
  if (rays) rows.push_back(rayTracedRow(*rays, probe.reference));
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.order < b.order; });
  const bool same = std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(),
                               [](const Row& a, const Row& b) { return a.id == b.id; });
  if (!same) beginResetModel();
  rows_ = std::move(rows);
  if (!same)
    endResetModel();
  else if (!rows_.empty())
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void ProbeTableModel::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

bool ProbeTableModel::hasGpuValues() const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [](const Row& row) { return row.gpu.has_value(); });
}

bool ProbeTableModel::hasBytes() const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [](const Row& row) { return row.bytes.has_value(); });
}

int ProbeTableModel::rowOf(const QString& id) const {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].id == id) return int(i);
  return -1;
}

QString ProbeTableModel::asText() const {
  const auto number = [](double value) { return QString::fromStdString(toText(value)); };
  const auto orNothing = [&](const std::optional<double>& value) {
    return value ? number(*value) : QString();
  };
  const bool bytes = hasBytes();
  QString text =
      QStringLiteral("technique\tvisibility\tgpu\terror") + (bytes ? "\tbytes per texel\n" : "\n");
  for (const Row& row : rows_) {
    if (!row.refusal.isEmpty() || row.pending)
      text += row.title + "\t\t\t";
    else
      text += row.title + "\t" + number(row.visibility) + "\t" + orNothing(row.gpu) + "\t" +
              number(row.error);
    text += (bytes ? "\t" + orNothing(row.bytes) : QString()) + "\n";
  }
  return text;
}

int ProbeTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(rows_.size());
}

int ProbeTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(ColumnCount);
}

Qt::ItemFlags ProbeTableModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Row& row = rows_[std::size_t(index.row())];
  if (!row.refusal.isEmpty()) return Qt::NoItemFlags;
  return row.id.isEmpty() ? Qt::ItemIsEnabled : QAbstractTableModel::flags(index);
}

QVariant ProbeTableModel::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[std::size_t(index.row())];
  switch (role) {
    case IdRole:
      return row.id;
    case ColourRole:
      return row.colour;
    case ErrorRole:
      return row.error;
    case Qt::ToolTipRole:
      if (!row.refusal.isEmpty()) return row.refusal;
      if (row.pending) return tr("%1: being computed\n%2").arg(row.title, row.citation);
      return tr("%1: v = %2, error %3 (%4)\n%5")
                 .arg(row.title, style::figure(row.visibility), style::signedFigure(row.error),
                      !isVisibleError(row.error) ? tr("no visible error")
                      : row.error > 0            ? tr("too light")
                                                 : tr("too dark"),
                      row.citation) +
             (row.bytes ? tr("\nIt stores %1 bytes per texel.").arg(*row.bytes) : QString());
    case Qt::DisplayRole:
      break;
    default:
      return {};
  }
  if (!row.refusal.isEmpty() && (index.column() == ValueColumn || index.column() == ErrorColumn))
    return QString(QChar(0x2013));
  if (row.pending && index.column() == ValueColumn) return QString(QChar(0x2026));
  if (row.pending && index.column() == ErrorColumn) return QString();
  switch (index.column()) {
    case TitleColumn:
      return row.title;
    case ValueColumn:
      return QString::number(row.visibility, 'f', 3);
    case GpuColumn:
      return row.gpu ? QString::number(*row.gpu, 'f', 3) : QString();
    case ErrorColumn:
      return style::signedFigure(row.error);
    case BytesColumn:
      return row.bytes ? QString::number(*row.bytes) : QString();
    default:
      return {};
  }
}

QVariant ProbeTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int(Qt::AlignVCenter | (section == TitleColumn ? Qt::AlignLeft : Qt::AlignRight));
  const QString names[] = {tr("technique"), tr("v"),     tr("GPU"),
                           tr("error"),     tr("bytes"), QString()};
  const QString toolTips[] = {{},
                              tr("Visibility at the receiver, 1 is lit"),
                              tr("Visibility that the shaded frame used at this pixel"),
                              tr("v − v_ref: positive is light bleeding, negative is too dark"),
                              tr("Bytes per texel of the shadow map that the method stores: its "
                                 "channels, without what the program adds to blur them"),
                              tr("The error from −1 to +1")};
  if (role == Qt::DisplayRole) return names[section];
  if (role == Qt::ToolTipRole) return toolTips[section];
  return {};
}

}  // namespace umbra
