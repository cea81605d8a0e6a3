// A pane's label shows its technique, which can be exchanged there, what tells it from the other
// panes, its error at the probe, and its menu.
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
  // `refusals` says by id why a technique cannot be chosen; those that it does not list can.
  void setRefusals(const QMap<QString, QString>& refusals);
  // Such as "radius 12 · half"; empty where there are no differences.
  void setDifferences(const QString& text);
  QString differences() const;
  // The active pane has the session's settings, and the mouse acts in it.
  void setActive(bool active);
  void setLinked(bool linked);  // shares its settings
  // None where there is no probe; the label then shows no error.
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
