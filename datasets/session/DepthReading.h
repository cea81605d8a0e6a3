// How a depth file is read, in the window and by every command.
#pragma once

#include "datasets/session/Session.h"

namespace umbra {

// The session's settings, for what its source is: a depth file's texels are read as they are,
// whatever a frame of a scene reads.
FrameSettings readSettingsOf(const Session& session);

// For a session that nobody has asked for a storage format: a depth file is read in double, which
// is stored nowhere, so that its figures are exact; a scene's textures hold floats at most.
void chooseFormatFor(Session& session);

}  // namespace umbra
