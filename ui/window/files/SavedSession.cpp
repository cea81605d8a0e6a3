#include "ui/window/files/SavedSession.h"

#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"

namespace umbra {

Session sessionToSave(const SessionController& controller, const SceneView& view,
                      const Prober& prober) {
  Session session = controller.session();
  if (!controller.document().content.scene) return session;
  const QSize size = view.pixels();
  const auto& report = prober.behindVeil();
  if (size.isEmpty()) return session;
  // The report may still be about a picture of another size.
  if (session.probe && report && report->pinned && report->point)
    session.probe = view.pixelOf(*report->point).value_or(report->pixel);
  if (!session.probe || (report && report->pinned)) {
    session.width = size.width();
    session.height = size.height();
  }
  return session;
}

Session sessionToRemember(const SessionController& controller, const SceneView& view,
                          const Prober& prober) {
  return controller.visiting() ? controller.ownSession() : sessionToSave(controller, view, prober);
}

}  // namespace umbra
