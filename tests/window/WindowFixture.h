// The window as a person uses it: what the classes of tests share. Such a class stands in a file of
// its name, its cases are its private slots, and the file's make…Test() gives it to Main.cpp.
#pragma once

#include <QEvent>
#include <QObject>
#include <QTemporaryDir>
#include <memory>

#include "ui/picture/ProbeReport.h"
#include "ui/window/MainWindow.h"

namespace umbra {

constexpr int patience = 60000;  // milliseconds; software OpenGL beside other work

class WindowFixture : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void cleanup();

 protected:
  // A window of 1300 × 800 on the workspace, its first frame drawn.
  MainWindow& open(const Workspace& workspace = {});
  MainWindow& open(const Session& session) { return open(Workspace{session}); }
  // Waits until the last frame shows the present session and every pane follows it.
  void settle();
  void mouse(QEvent::Type type, const QPointF& point, Qt::MouseButton button,
             Qt::MouseButtons buttons);
  // Settles, and waits until the pictures beside the view have followed it.
  void settlePanes();
  void click(const Pixel& pixel);
  void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  QPointF pointOf(const Pixel& pixel);
  // Both write into the folder and give the whole name. Depths become channel Z of an OpenEXR file.
  std::string writeFile(const char* name, const std::string& bytes);
  std::string writeDepths(const char* name, const Image<float>& depths);
  // Waits until the source that is open has this title, and settles.
  void untilOpen(const char* title);
  // The result of technique `id` in the present report.
  const TechniqueResult& result(const char* id);

  QTemporaryDir folder_;  // of the settings, and for files
  std::unique_ptr<MainWindow> window_;
};

}  // namespace umbra
