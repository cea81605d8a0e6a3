// A pane's label: its technique, to be exchanged there, and its error at the probe.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "filters/core/Technique.h"

class QComboBox;
class QLabel;

namespace umbra {

// "Variance (VSM)" is VSM to those who have read its title in the list.
QString shortTitle(const Technique& technique);

class PaneHeader : public QWidget {
  Q_OBJECT

 public:
  explicit PaneHeader(const std::vector<const Technique*>& techniques, QWidget* parent = nullptr);

  void setTechnique(const QString& id);  // emits nothing
  QString technique() const;
  // The pane is the one that the session's settings and the mouse are about.
  void setActive(bool active);
  // Nothing where there is no probe.
  void setError(const std::optional<double>& error);
  QString errorText() const;

 signals:
  void techniqueChosen(const QString& id);  // by hand

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QComboBox* box_;
  QLabel* error_;
  bool active_ = false;
};

}  // namespace umbra
