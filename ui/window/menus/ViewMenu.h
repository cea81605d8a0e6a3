// What the picture shows, and from where.
#pragma once

#include <QMenu>

class QActionGroup;

namespace umbra {

class CompareMenu;
class SessionController;

class ViewMenu : public QMenu {
  Q_OBJECT

 public:
  explicit ViewMenu(SessionController& controller, QWidget* parent = nullptr);

  // One for each ViewMode; the session's is checked.
  QList<QAction*> modes() const;
  CompareMenu& compare() { return *compare_; }

 private:
  void addModes();
  void addForm(const QString& title, QWidget* form);
  void refresh();

  SessionController& controller_;
  QActionGroup* modes_;
  CompareMenu* compare_ = nullptr;
};

}  // namespace umbra
