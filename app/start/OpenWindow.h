// `umbrascope [SCENE | MESH | DEPTH.exr | SESSION.json]`: the window.
#pragma once

#include <optional>
#include <string>

#include "app/options/SessionOptions.h"

namespace umbra {

class OpenWindow {
 public:
  // Adds the argument and the session options to the program itself.
  explicit OpenWindow(OptionParser& program);

  bool given() const;
  // Throws BadCommandLine when the argument names nothing that can be opened, with the nearest
  // command or scene.
  void checkArgument() const;
  // Opens the window and returns its exit status. Throws NoOpenGL where there is no display.
  int run(int& argc, char** argv) const;

 private:
  Workspace opened() const;

  OptionParser& program_;
  std::optional<std::string> argument_;
  SessionOptions options_;
};

}  // namespace umbra
