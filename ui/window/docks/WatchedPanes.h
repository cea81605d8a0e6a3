// The panes whose contents cost so much work that they are made only while somebody looks at them.
#pragma once

#include <QObject>

class QDockWidget;
class QWidget;

namespace umbra {

class ErrorController;
class ErrorPane;
class EvidencePanes;
class ExplainPane;
class LayersController;
class LayersPane;
class Prober;
class SceneView;
class SessionController;

// Makes the panes; the docks that they are put into own them.
class WatchedPanes : public QObject {
  Q_OBJECT

 public:
  WatchedPanes(SessionController& controller, SceneView& view, Prober& prober,
               EvidencePanes& evidence, QObject* parent = nullptr);

  QWidget& layers();
  QWidget& explain();
  QWidget& error();
  // From now on each pane works while its dock is in sight.
  void follow(const QDockWidget& layers, const QDockWidget& explain, const QDockWidget& error);

 signals:
  void message(const QString& text);
  void failed(const QString& problem);  // one line for people

 private:
  LayersController* layersController_;
  LayersPane* layers_;
  ExplainPane* explain_;
  ErrorController* errorController_;
  ErrorPane* error_;
};

}  // namespace umbra
