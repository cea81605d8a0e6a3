// The buttons above the picture.
#pragma once

#include <QToolBar>

class QMenu;
class QToolButton;

namespace umbra {

class SceneForm;
class SessionController;
class WindowMenus;

class WindowToolBar : public QToolBar {
  Q_OBJECT

 public:
  WindowToolBar(SessionController& controller, WindowMenus& menus, QWidget* parent = nullptr);

 private:
  QToolButton* addMenuButton(const QString& text, QMenu* menu);
  QMenu* menuOf(QWidget* form);
  void refresh();

  SessionController& controller_;
  SceneForm* sceneForm_;
  QToolButton *scene_ = nullptr, *adjust_ = nullptr;
};

}  // namespace umbra
