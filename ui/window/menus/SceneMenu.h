// The scenes of the catalogue, and what else can be opened.
#pragma once

#include <QMenu>

namespace umbra {

class FileActions;
class SessionController;

class SceneMenu : public QMenu {
  Q_OBJECT

 public:
  SceneMenu(SessionController& controller, FileActions& files, QWidget* parent = nullptr);
};

}  // namespace umbra
