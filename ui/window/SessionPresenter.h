// Keeps the picture and the probe in step with the session, and the session with what the mouse
// does in the picture.
#pragma once

#include <QObject>

namespace umbra {

class EvidencePanes;
class Prober;
class SceneView;
class SessionController;
struct Document;

class SessionPresenter : public QObject {
  Q_OBJECT

 public:
  SessionPresenter(SessionController& controller, SceneView& view, Prober& prober,
                   EvidencePanes& evidence, QObject* parent = nullptr);

  // Shows the document that is open. Must be called once, when all parts of the window listen.
  void start();
  // The document has or lacks a probe on purpose: the next frame must place none by itself.
  void keepProbe() { probeNextFrame_ = false; }

 signals:
  void failed(const QString& problem);  // one line for people

 private:
  void show(const Document& before, const Document& after);
  void afterFrame();
  void followMouse();

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  EvidencePanes& evidence_;
  bool probeNextFrame_ = true;  // a scene was opened and nobody has pointed at anything yet
};

}  // namespace umbra
