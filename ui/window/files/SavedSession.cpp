#include "ui/window/files/SavedSession.h"

#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"

namespace umbra {

Workspace sessionToSave(const SessionController& controller, const SceneView& view,
                        const Prober& prober) {
  Workspace workspace = controller.workspace();
  Session& session = workspace.shared;
  if (!controller.document().content.scene) return workspace;
  const QSize size = view.pixels();
  const auto& report = prober.behindVeil();
  if (size.isEmpty()) return workspace;
  // The report may still be about a picture of another size.
  if (session.probe && report && report->pinned && report->point)
    session.probe = view.pixelOf(*report->point).value_or(report->pixel);
  if (!session.probe || (report && report->pinned)) {
    session.width = size.width();
    session.height = size.height();
  }
  return workspace;
}

Workspace sessionToRemember(const SessionController& controller, const SceneView& view,
                            const Prober& prober) {
  return controller.visiting() ? controller.ownWorkspace()
                               : sessionToSave(controller, view, prober);
}

}  // namespace umbra
