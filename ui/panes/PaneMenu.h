// What can be done to one pane of a comparison.
#pragma once

#include <QMenu>

#include "datasets/session/PaneEditing.h"

namespace umbra {

class SessionController;

// The menu is filled anew each time that it opens.
class PaneMenu : public QMenu {
  Q_OBJECT

 public:
  // `pane` counts as in comparisonOf().
  PaneMenu(SessionController& controller, std::size_t pane, QWidget* parent = nullptr);

 private:
  void fill();
  void fillOwn(const Pane& pane);
  void add(const QString& text, const QString& help, bool possible,
           void (*change)(Workspace&, std::size_t));

  SessionController& controller_;
  std::size_t pane_;
  QMenu* own_;
};

}  // namespace umbra
