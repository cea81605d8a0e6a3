// Chooses the session's technique.
#pragma once

#include <QMenu>

class QActionGroup;

namespace umbra {

class SessionController;

class TechniqueMenu : public QMenu {
  Q_OBJECT

 public:
  explicit TechniqueMenu(SessionController& controller, QWidget* parent = nullptr);

 private:
  void addTechniques();
  void refresh();

  SessionController& controller_;
  QActionGroup* techniques_;  // in the catalogue's order
};

}  // namespace umbra
