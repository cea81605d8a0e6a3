// Whether a window can open here, found out before Qt does, which ends the process where none can.
#pragma once

#include <string>

namespace umbra {

// Why no window can open, for an error message; empty where one may. Looks at DISPLAY,
// WAYLAND_DISPLAY and QT_QPA_PLATFORM, and connects to the X server where that is what Qt will use.
std::string windowObstacle();

}  // namespace umbra
