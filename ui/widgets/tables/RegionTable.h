// The statistics of the probed region.
#pragma once

#include <QPoint>
#include <QVector>

#include "analysis/probe/Probe.h"
#include "ui/widgets/base/Card.h"

class QLabel;

namespace umbra {

class RegionTable : public Card {
  Q_OBJECT

 public:
  explicit RegionTable(QWidget* parent = nullptr);

  // `origin` is what the map's first texel is called.
  void setProbe(const Probe& probe, const QPoint& origin = {});
  void clear();

  // "label\tfigure", a line each.
  QString asText() const;

 private:
  struct Row {
    QLabel* label;
    QLabel* figure;
  };
  void set(int row, const QString& figure);

  QVector<Row> rows_;
};

}  // namespace umbra
