#include "ui/window/RunWindow.h"

#include <QApplication>
#include <QOpenGLContext>
#include <QTimer>
#include <memory>
#include <string>

#include "datasets/maps/RawDepths.h"
#include "filters/core/support/Error.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMemory.h"
#include "ui/window/WindowStyle.h"

namespace umbra {
namespace {

// The render passes need OpenGL 4.5. This is asked before a window stands there with nothing in it.
void requireOpenGL() {
  QOpenGLContext context;
  const bool made = context.create();
  const auto [major, minor] = context.format().version();
  if (made && (major > 4 || (major == 4 && minor >= 5))) return;
  throw Error(ErrorKind::NoOpenGL,
              made ? "the display offers OpenGL " + std::to_string(major) + "." +
                         std::to_string(minor) + ", the window needs 4.5; a newer driver has it"
                   : std::string("the display offers no OpenGL, the window needs 4.5; "
                                 "Mesa (package libgl1-mesa-dri) has it in software"));
}

// Whether another reading of the file may succeed: its values can be counted.
bool isReadable(const SceneSource& source) {
  if (source.kind != SourceKind::DepthFile) return false;
  try {
    readRawDepths(source.name, source.depth.channel);
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::unique_ptr<MainWindow> windowOn(const Workspace& workspace) {
  try {
    return std::make_unique<MainWindow>(workspace);
  } catch (const Error&) {
    if (!isReadable(workspace.shared.source)) throw;
  }
  const Workspace nothing;
  auto window = std::make_unique<MainWindow>(nothing);
  const auto ask = [&window = *window, workspace] { window.controller().open(workspace); };
  QTimer::singleShot(0, window.get(), ask);
  return window;
}

int runWindow(int& argc, char** argv, const Workspace& workspace) {
  prepareApplication();
  QApplication application(argc, argv);
  applyStyle(application);
  requireOpenGL();
  std::unique_ptr<MainWindow> window;
  if (workspace == Workspace{})
    if (const auto last = lastSession()) try {
        window = std::make_unique<MainWindow>(*last);
      } catch (const Error&) {
        window.reset();  // its file has gone: begin with what was asked for
      }
  if (!window) window = windowOn(workspace);
  restoreWindow(*window);
  QObject::connect(window.get(), &MainWindow::closing, [&] { rememberWindow(*window); });
  window->show();
  return QApplication::exec();
}

}  // namespace umbra
