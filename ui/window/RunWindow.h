// The window, from start to close.
#pragma once

#include "datasets/session/Session.h"

namespace umbra {

// Opens the window on `session` and returns its exit status when it is closed. A session that
// equals Session{} asks for nothing in particular: then the one of the last window is opened, if
// there is one and it can be read. Throws NoOpenGL where there is no context of OpenGL 4.5 or
// better, BadInput where the session's source cannot be read.
int runWindow(int& argc, char** argv, const Session& session);

}  // namespace umbra
