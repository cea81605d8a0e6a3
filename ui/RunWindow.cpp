#include "ui/RunWindow.h"

#include <QVTKOpenGLNativeWidget.h>
#include <QApplication>
#include <QSurfaceFormat>
#include <exception>

#include "filters/core/Error.h"
#include "ui/MainWindow.h"
#include "ui/WindowMemory.h"
#include "ui/WindowStyle.h"

namespace umbra {
namespace {

// Before the application exists: it fixes how every OpenGL context is made.
void prepareApplication() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  QCoreApplication::setOrganizationName("Umbrascope");
  QCoreApplication::setApplicationName("Umbrascope");
}

}  // namespace

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
