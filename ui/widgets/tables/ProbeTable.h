// What every technique makes of the probed region, and how far that is from the truth.
#pragma once

#include <optional>

#include "ui/widgets/base/Card.h"
#include "ui/widgets/tables/ProbeTableModel.h"

class QLabel;
class QTableView;

namespace umbra {

class ProbeTable : public Card {
  Q_OBJECT

 public:
  explicit ProbeTable(QWidget* parent = nullptr);

  // One row per technique of the probe, in its order, and below them the ray-traced truth where
  // there is one; `selected` is an id.
  void setProbe(const Probe& probe, const QString& selected,
                const std::optional<RayTracedRow>& rays = {},
                std::optional<StorageFormat> format = {});
  void setSelected(const QString& id);
  // Removes the rows and shows a hint in their place; an empty one says how to get rows.
  void clear(const QString& hint = {});

  // Tab separated with a header line, numbers in full precision; for spreadsheets.
  QString asText() const;
  QTableView* view() { return view_; }

 public slots:
  void copy() const;  // asText to the clipboard

 signals:
  // Emitted after a click or an arrow key, never by setSelected.
  void techniqueChosen(const QString& id);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void arrangeColumns();
  void showHint(bool shown);

  ProbeTableModel* model_;
  QTableView* view_;
  QLabel* hint_;
  bool quiet_ = false;  // while setSelected moves the selection
};

}  // namespace umbra
