// The session as a file keeps it.
#pragma once

#include "datasets/session/Workspace.h"

namespace umbra {

class Prober;
class SceneView;
class SessionController;

// What is shown now, with the picture's size in device pixels and with the pixel that shows the
// pinned point, so that the file opens to the same picture and probe elsewhere.
Workspace sessionToSave(const SessionController& controller, const SceneView& view,
                        const Prober& prober);
// The person's own session, also while a lesson shows another one.
Workspace sessionToRemember(const SessionController& controller, const SceneView& view,
                            const Prober& prober);

}  // namespace umbra
