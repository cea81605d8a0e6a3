#include "ui/window/SessionPresenter.h"

#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/window/files/Attempt.h"

namespace umbra {

SessionPresenter::SessionPresenter(SessionController& controller, SceneView& view, Prober& prober,
                                   EvidencePanes& evidence, QObject* parent)
    : QObject(parent), controller_(controller), view_(view), prober_(prober), evidence_(evidence) {
  connect(&controller_, &SessionController::changed, this, &SessionPresenter::show);
  connect(&view_, &SceneView::frameDrawn, this, &SessionPresenter::afterFrame);
  followMouse();
}

void SessionPresenter::start() {
  view_.showDocument(controller_.document(), controller_.technique());
  // A depth file is drawn in no frame that would call for its probe. The panes have their sizes
  // only after this returned.
  if (controller_.document().content.depth)
    QMetaObject::invokeMethod(&prober_, &Prober::refresh, Qt::QueuedConnection);
}

void SessionPresenter::show(const Document& before, const Document& after) {
  if (!(before.content == after.content)) probeNextFrame_ = after.content.scene != nullptr;
  attempt([&] { view_.showDocument(after, controller_.technique()); },
          [this](const QString& problem) { emit failed(problem); });
  if (!view_.stale()) probeNextFrame_ = false;  // no frame follows
  // What needs a frame waits for the one that follows.
  if (after.content.depth || view_.upToDate()) evidence_.refreshMap();
  if (view_.upToDate()) prober_.refresh();
}

void SessionPresenter::afterFrame() {
  if (!probeNextFrame_ || view_.stale()) return;
  probeNextFrame_ = false;
  // A newcomer sees at once what the program is for.
  if (!controller_.session().probe) prober_.startAtWorstBleeding();
}

void SessionPresenter::followMouse() {
  connect(&view_, &SceneView::cameraMoved, this, [this](const Camera& camera) {
    controller_.edit(
        tr("Move camera"), [&](Session& s) { s.camera = camera; }, "camera");
  });
  connect(&view_, &SceneView::lightDragged, this, [this](const Light& light) {
    controller_.edit(
        tr("Move light"), [&](Session& s) { s.light = light; }, "light");
  });
  connect(&view_, &SceneView::lightDragFinished, this, [this] { controller_.endMerge(); });
}

}  // namespace umbra
