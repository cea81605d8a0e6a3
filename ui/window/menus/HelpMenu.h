// What the program says about itself and its techniques.
#pragma once

#include <QMenu>

namespace umbra {

class SessionController;

class HelpMenu : public QMenu {
  Q_OBJECT

 public:
  // The keys that it lists are those of all of the window's actions.
  HelpMenu(SessionController& controller, QWidget& window, QWidget* parent = nullptr);

 private:
  void listKeys();

  QWidget& window_;
};

}  // namespace umbra
