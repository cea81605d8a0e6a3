#include "app/start/WindowSystem.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string_view>

namespace umbra {
namespace {

std::string_view setting(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

// The X client library is loaded by name: the program is to start where there is none.
bool xServerAnswers() {
  void* library = dlopen("libxcb.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library) return true;  // nobody to ask; Qt then says what it misses
  using Connect = void* (*)(const char*, int*);
  using HasError = int (*)(void*);
  using Disconnect = void (*)(void*);
  const auto connect = reinterpret_cast<Connect>(dlsym(library, "xcb_connect"));
  const auto hasError = reinterpret_cast<HasError>(dlsym(library, "xcb_connection_has_error"));
  const auto disconnect = reinterpret_cast<Disconnect>(dlsym(library, "xcb_disconnect"));
  if (!connect || !hasError || !disconnect) return true;
  void* connection = connect(nullptr, nullptr);
  const bool answers = hasError(connection) == 0;
  disconnect(connection);  // takes a failed one as well
  return answers;
}

}  // namespace

std::string windowObstacle() {
  const std::string_view display = setting("DISPLAY"), platform = setting("QT_QPA_PLATFORM");
  const bool wayland = !setting("WAYLAND_DISPLAY").empty();
  if (display.empty() && !wayland) return "DISPLAY and WAYLAND_DISPLAY are not set";
  const bool onX = platform.empty() ? !wayland : platform.starts_with("xcb");
  if (onX && !display.empty() && !xServerAnswers())
    return "DISPLAY is " + std::string(display) + ", where no X server answers";
  return {};
}

}  // namespace umbra
