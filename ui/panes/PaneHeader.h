// A pane's label: its technique, to be exchanged there, what tells it from the other panes, its
// error at the probe, and its menu.
#pragma once

#include <QMap>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "filters/core/technique/Technique.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QMenu;
class QToolButton;

namespace umbra {

class ElidedLabel;

class PaneHeader : public QWidget {
  Q_OBJECT

 public:
  PaneHeader(const std::vector<const Technique*>& techniques, QMenu& menu,
             QWidget* parent = nullptr);

  void setTechnique(const QString& id);  // emits nothing
  QString technique() const;
  // Why a technique cannot be chosen, by id; the others can.
  void setRefusals(const QMap<QString, QString>& refusals);
  // "radius 12 · half"; empty where there are none.
  void setDifferences(const QString& text);
  QString differences() const;
  // The pane is the one that the session's settings and the mouse are about.
  void setActive(bool active);
  void setLinked(bool linked);  // shares its settings
  // Nothing where there is no probe.
  void setError(const std::optional<double>& error);
  QString errorText() const;

 signals:
  void techniqueChosen(const QString& id);  // by hand
  void chosen();                            // by a click beside its buttons

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void place();
  void explain();

  QGridLayout* layout_;
  QComboBox* box_;
  QStringList titles_;  // of its techniques
  ElidedLabel* differences_;
  QLabel* error_;
  QToolButton* menuButton_;
  QMenu& menu_;
  enum class Place { Nowhere, Beside, Beneath };
  Place place_ = Place::Nowhere;  // of what differs, in relation to the technique
  bool active_ = false, linked_ = true;
};

}  // namespace umbra
