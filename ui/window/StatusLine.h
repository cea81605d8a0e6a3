// The line at the bottom of the window: the scene, what its frame cost, and the map.
#pragma once

#include <QObject>

class QLabel;
class QStatusBar;

namespace umbra {

class SceneView;
class SessionController;

class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(QStatusBar& bar, SessionController& controller, SceneView& view);

 public slots:
  void showMessage(const QString& text);  // for some seconds, in the place of the scene

 private:
  void refresh();
  void showScene();
  void showFrame();

  QStatusBar& bar_;
  SessionController& controller_;
  SceneView& view_;
  QLabel *scene_, *frame_, *map_;
};

}  // namespace umbra
