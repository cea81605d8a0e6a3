// The window, from start to close.
#pragma once

#include <memory>

#include "datasets/session/Workspace.h"

namespace umbra {

class MainWindow;

// A window that is not shown yet. Throws BadInput where the workspace's source cannot be read; a
// depth map that may be read in another way brings up the sheet that asks how.
std::unique_ptr<MainWindow> windowOn(const Workspace& workspace);

// Opens the window on `workspace` and returns its exit status when it is closed. One that equals
// Workspace{} asks for nothing in particular: then the one of the last window is opened, if there
// is one and it can be read. Throws NoOpenGL where there is no context of OpenGL 4.5 or
// better, BadInput where its source cannot be read in any way.
int runWindow(int& argc, char** argv, const Workspace& workspace);

}  // namespace umbra
