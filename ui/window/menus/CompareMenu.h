// Puts techniques beside each other.
#pragma once

#include <QMenu>

class QActionGroup;

namespace umbra {

class SessionController;

class CompareMenu : public QMenu {
  Q_OBJECT

 public:
  explicit CompareMenu(SessionController& controller, QWidget* parent = nullptr);

 private:
  void addModes();
  void addDuplicate();
  void addCounts();
  void addWipe();
  void refresh();

  SessionController& controller_;
  QActionGroup* modes_;  // one for each ComparisonMode
  QAction* duplicate_ = nullptr;
};

}  // namespace umbra
