#include "ui/window/docks/WatchedPanes.h"

#include <QDockWidget>

#include "ui/errors/ErrorController.h"
#include "ui/errors/ErrorPane.h"
#include "ui/layers/LayersController.h"
#include "ui/layers/LayersPane.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/ExplainPane.h"

namespace umbra {

WatchedPanes::WatchedPanes(SessionController& controller, SceneView& view, Prober& prober,
                           EvidencePanes& evidence, QObject* parent)
    : QObject(parent),
      layersController_(new LayersController(controller, view, this)),
      layers_(new LayersPane(*layersController_, controller)),
      explain_(new ExplainPane(controller, prober)),
      errorController_(new ErrorController(controller, view, prober, this)),
      error_(new ErrorPane(*errorController_, prober)) {
  evidence.follow(explain_->plot());
  connect(layersController_, &LayersController::failed, this, &WatchedPanes::failed);
  connect(layers_, &LayersPane::message, this, &WatchedPanes::message);
  connect(errorController_, &ErrorController::failed, this, &WatchedPanes::failed);
}

QWidget& WatchedPanes::layers() {
  return *layers_;
}

QWidget& WatchedPanes::explain() {
  return *explain_;
}

QWidget& WatchedPanes::error() {
  return *error_;
}

// Only visibilityChanged tells whether a dock is in sight: isVisible() also holds for one that lies
// behind the tab of another.
void WatchedPanes::follow(const QDockWidget& layers, const QDockWidget& explain,
                          const QDockWidget& error) {
  connect(&layers, &QDockWidget::visibilityChanged, layersController_,
          &LayersController::setWatched);
  connect(&explain, &QDockWidget::visibilityChanged, explain_, &ExplainPane::setWatched);
  connect(&error, &QDockWidget::visibilityChanged, errorController_, &ErrorController::setWatched);
}

}  // namespace umbra
