// What the window remembers from one start to the next: geometry, docks and the last session.
#pragma once

#include <optional>

#include "datasets/session/Workspace.h"

namespace umbra {

class MainWindow;

// The session that was open last; none on the first start, or where it cannot be read any more.
std::optional<Workspace> lastSession();

// Puts geometry and docks back; the default arrangement where there is nothing to put back.
void restoreWindow(MainWindow& window);

// Never throws: a full disk must not keep a window from closing.
void rememberWindow(MainWindow& window);

}  // namespace umbra
