#include "tests/window/WindowFixture.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSettings>
#include <QTest>
#include <fstream>

#include "datasets/maps/ExrFile.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/window/CentrePane.h"

namespace umbra {

void WindowFixture::initTestCase() {
  QVERIFY(folder_.isValid());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
}

void WindowFixture::cleanup() {
  window_.reset();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

MainWindow& WindowFixture::open(const Workspace& workspace) {
  window_ = std::make_unique<MainWindow>(workspace);
  window_->resize(1300, 800);
  window_->resetLayout();
  window_->show();
  QApplication::setActiveWindow(window_.get());
  settle();
  return *window_;
}

void WindowFixture::settle() {
  const auto still = [this] {
    const bool onScene = window_->controller().document().content.scene != nullptr;
    return !window_->controller().loading() && (!onScene || window_->view().upToDate());
  };
  // Twice: what follows a frame, such as the first probe, may ask for another one.
  for (int i = 0; i < 2; ++i) {
    QVERIFY(QTest::qWaitFor(still, patience));
    QTest::qWait(50);
  }
}

void WindowFixture::settlePanes() {
  settle();
  ComparisonPanes& panes = window_->centre().comparison();
  QVERIFY(QTest::qWaitFor([&] { return panes.upToDate(); }, patience));
}

void WindowFixture::mouse(QEvent::Type type, const QPointF& point, Qt::MouseButton button,
                          Qt::MouseButtons buttons) {
  SceneView& view = window_->view();
  QMouseEvent event(type, point, view.mapToGlobal(point.toPoint()), button, buttons,
                    Qt::NoModifier);
  QCoreApplication::sendEvent(&view, &event);
}

void WindowFixture::click(const Pixel& pixel) {
  mouse(QEvent::MouseButtonPress, pointOf(pixel), Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, pointOf(pixel), Qt::LeftButton, Qt::NoButton);
  settle();
}

void WindowFixture::key(int key, Qt::KeyboardModifiers modifiers) {
  window_->view().setFocus();
  QTest::keyClick(&window_->view(), Qt::Key(key), modifiers);
  settle();
}

QPointF WindowFixture::pointOf(const Pixel& pixel) {
  const double ratio = window_->view().devicePixelRatioF();
  return {(pixel.x + 0.5) / ratio, (pixel.y + 0.5) / ratio};
}

std::string WindowFixture::writeFile(const char* name, const std::string& bytes) {
  const std::string file = folder_.filePath(name).toStdString();
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::string WindowFixture::writeDepths(const char* name, const Image<float>& depths) {
  const std::string file = folder_.filePath(name).toStdString();
  writeExr(file, {{"Z", depths}}, {});
  return file;
}

void WindowFixture::untilOpen(const char* title) {
  QTRY_COMPARE_WITH_TIMEOUT(titleOf(window_->controller().session().source), std::string(title),
                            patience);
  settle();
}

const TechniqueResult& WindowFixture::result(const char* id) {
  const auto& report = window_->prober().report();
  const TechniqueResult* found = report ? resultOf(report->probe, id) : nullptr;
  if (!found) qFatal("there is no probe of %s", id);
  return *found;
}

}  // namespace umbra
