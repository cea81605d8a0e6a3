#include "ui/RunWindow.h"

#include <QApplication>
#include <memory>

#include "filters/core/Error.h"
#include "ui/MainWindow.h"
#include "ui/WindowMemory.h"
#include "ui/WindowStyle.h"

namespace umbra {

int runWindow(int& argc, char** argv, const Session& session) {
  prepareApplication();
  QApplication application(argc, argv);
  applyStyle(application);
  std::unique_ptr<MainWindow> window;
  if (session == Session{})
    if (const auto last = lastSession()) try {
        window = std::make_unique<MainWindow>(*last);
      } catch (const Error&) {
        window.reset();  // its file has gone: begin with what was asked for
      }
  if (!window) window = std::make_unique<MainWindow>(session);
  restoreWindow(*window);
  QObject::connect(window.get(), &MainWindow::closing, [&] { rememberWindow(*window); });
  window->show();
  return QApplication::exec();
}

}  // namespace umbra
