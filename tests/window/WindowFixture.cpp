#include "tests/window/WindowTest.h"

#include <QAbstractItemModel>
#include <QApplication>
#include <QDockWidget>
#include <QMouseEvent>
#include <QSettings>
#include <QTableView>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "analysis/rays/RayTracedVisibility.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/window/WindowMemory.h"
#include "ui/window/WindowStyle.h"

namespace umbra {
void WindowTest::initTestCase() {
  QVERIFY(folder_.isValid());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
}

void WindowTest::cleanup() {
  window_.reset();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

MainWindow& WindowTest::open(const Session& session) {
  window_ = std::make_unique<MainWindow>(session);
  window_->resize(1300, 800);
  window_->resetLayout();
  window_->show();
  QApplication::setActiveWindow(window_.get());
  settle();
  return *window_;
}

void WindowTest::settle() {
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

void WindowTest::mouse(QEvent::Type type, const QPointF& point, Qt::MouseButton button,
                       Qt::MouseButtons buttons) {
  SceneView& view = window_->view();
  QMouseEvent event(type, point, view.mapToGlobal(point.toPoint()), button, buttons,
                    Qt::NoModifier);
  QCoreApplication::sendEvent(&view, &event);
}

void WindowTest::click(const Pixel& pixel) {
  mouse(QEvent::MouseButtonPress, pointOf(pixel), Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, pointOf(pixel), Qt::LeftButton, Qt::NoButton);
  settle();
}

void WindowTest::key(int key, Qt::KeyboardModifiers modifiers) {
  window_->view().setFocus();
  QTest::keyClick(&window_->view(), Qt::Key(key), modifiers);
  settle();
}

QPointF WindowTest::pointOf(const Pixel& pixel) {
  const double ratio = window_->view().devicePixelRatioF();
  return {(pixel.x + 0.5) / ratio, (pixel.y + 0.5) / ratio};
}

const TechniqueResult& WindowTest::result(const char* id) {
  const auto& report = window_->prober().report();
  const TechniqueResult* found = report ? resultOf(report->probe, id) : nullptr;
  if (!found) qFatal("there is no probe of %s", id);
  return *found;
}

void WindowTest::theFirstFrameShowsWhereLightBleeds() {
  MainWindow& window = open();
  const auto& report = window.prober().report();
  QVERIFY(report.has_value());
  QVERIFY(report->pinned);
  QVERIFY(report->probe.reference < 0.1);
  QVERIFY(result("vsm").error > 0.05);
  QVERIFY(!report->footprint.empty());
  QVERIFY(!window.controller().undoStack().canUndo());  // nobody has done anything yet
}

void WindowTest::theTableAgreesWithTheAnalysis() {
  Session session;
  session.source.name = "three-planes";
  MainWindow& window = open(session);
  const QSize size = window.view().pixels();
  // The pixel of the first probe, and one that nobody chose.
  for (const Pixel& pixel :
       {window.prober().report()->pixel, Pixel{size.width() * 2 / 5, size.height() * 4 / 5}}) {
    const auto surface = window.view().surfaceAt(pixel);
    QVERIFY(surface.has_value());
    click(pixel);
    const FrameSettings& frame = window.controller().session().frame;
    const DepthMap map = window.view().lastFrame()->depthMap();
    ProbeRequest request{map,
                         {frame.read.filter, surface->u, surface->v, {}},
                         frame.kernel,
                         frame.map.format,
                         surface->receiver,
                         {}};
    for (const auto& technique : window.controller().techniques()) {
      std::shared_ptr<Technique> adapted = technique->clone();
      adapted->adapt(map);
      request.techniques.push_back(adapted);
    }
    const Probe expected = takeProbe(request);
    const QAbstractItemModel& table = *window.evidence().table().view()->model();
    const int techniques = int(expected.techniques.size());
    QCOMPARE(table.rowCount(), techniques + 1);
    const auto cell = [&](int row, int column) {
      return table.index(row, column).data().toString();
    };
    for (int row = 0; row < techniques; ++row) {
      const TechniqueResult& one = expected.techniques[std::size_t(row)];
      QCOMPARE(cell(row, 0), style::text(one.technique->info().title));
      QCOMPARE(cell(row, 1), QString::number(one.visibility, 'f', 3));
      QCOMPARE(cell(row, 3), style::signedFigure(one.error));
    }
    const RayTracedVisibility rays(*window.controller().document().content.scene,
                                   window.view().lastFrame()->cascades(), map.width(), false,
                                   RayTracedVisibility::largestSide);
    const double traced = rays(expected.region, expected.receiver);
    QTRY_COMPARE_WITH_TIMEOUT(cell(techniques, 1), QString::number(traced, 'f', 3), patience);
    QCOMPARE(cell(techniques, 3), style::signedFigure(traced - expected.reference));
  }
}

void WindowTest::hoveringProbesAndLeavingKeepsTheProbe() {
  MainWindow& window = open();
  const Pixel pixel = window.prober().report()->pixel;
  key(Qt::Key_Escape);
  QVERIFY(!window.controller().session().probe);
  QVERIFY(!window.prober().report());
  mouse(QEvent::MouseMove, pointOf(pixel), Qt::NoButton, Qt::NoButton);
  QTRY_VERIFY_WITH_TIMEOUT(window.prober().report().has_value(), patience);
  QVERIFY(!window.prober().report()->pinned);
  QVERIFY(window.prober().report()->pixel == pixel);
  QVERIFY(!window.controller().session().probe);
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&window.view(), &leave);
  QVERIFY(window.prober().report().has_value());
}

void WindowTest::aPinnedProbeStaysOnItsPoint() {
  MainWindow& window = open();
  const Eigen::Vector3d point = *window.prober().report()->point;
  const Pixel pixel = window.prober().report()->pixel;
  const Scene& scene = *window.controller().document().content.scene;
  Camera camera = scene.camera;
  const Eigen::Vector3d way = camera.position - camera.target;
  camera.position += 0.1 * way.cross(camera.up);
  emit window.view().cameraMoved(camera);
  settle();
  const auto& report = window.prober().report();
  QVERIFY(report->pinned);
  QVERIFY(!(report->pixel == pixel));
  // Of two neighbouring pixels both may be nearest to the point.
  const double pixelSize = 2.0 * way.norm() / window.view().pixels().height();
  QVERIFY((*report->point - point).norm() < 4.0 * pixelSize);
  // Pinned elsewhere, it comes back to its point by undo, wherever that is seen by now.
  const QSize size = window.view().pixels();
  click({size.width() / 4, size.height() - 20});
  QVERIFY((*window.prober().report()->point - point).norm() > 40.0 * pixelSize);
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY((*window.prober().report()->point - point).norm() < 4.0 * pixelSize);
}

// Out of the picture the probe has no pixel, and still follows what is set.
void WindowTest::aHiddenProbeFollowsTheParameters() {
  MainWindow& window = open();
  QVERIFY(result("vsm").gpu.has_value());
  const double before = result("vsm").visibility;
  const Probe seen = window.prober().report()->probe;
  Camera camera = window.controller().document().content.scene->camera;
  const Eigen::Vector3d way = camera.target - camera.position;
  camera.target = camera.position - way;  // looks the other way
  emit window.view().cameraMoved(camera);
  settle();
  QVERIFY(!result("vsm").gpu.has_value());
  QCOMPARE(result("vsm").visibility, before);
  window.controller().edit("Reduce bleeding", [](Session& session) {
    session.parameters["vsm"]["bleed-reduction"] = 0.3;
  });
  settle();
  // Lauritzen 2008, §3.4: (p − a) / (1 − a).
  const double expected = std::max(0.0, (before - 0.3) / 0.7);
  QVERIFY(expected != before);
  QVERIFY(std::abs(result("vsm").visibility - expected) < 1e-12);
  QCOMPARE(window.prober().report()->probe.receiver, seen.receiver);
  QCOMPARE(window.prober().report()->probe.reference, seen.reference);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(result("vsm").gpu.has_value());
  QCOMPARE(result("vsm").visibility, before);
}

void WindowTest::theSmallestScreenHoldsEverything() {
  MainWindow& window = open();
  window.resize(1280, 720);
  window.resetLayout();
  settle();
  QCOMPARE(window.size(), QSize(1280, 720));
  std::vector<QRect> places{window.centralWidget()->geometry()};
  for (const QDockWidget* dock : window.docks()) {
    if (!dock->visibleRegion().isEmpty()) places.push_back(dock->geometry());
  }
  QVERIFY(places.size() >= 5);  // picture, controls, table, map, the plot on top
  for (std::size_t i = 0; i < places.size(); ++i) {
    QVERIFY(window.rect().contains(places[i]));
    for (std::size_t j = 0; j < i; ++j) QVERIFY(!places[i].intersects(places[j]));
  }
  QVERIFY(window.view().width() >= 400 && window.view().height() >= 240);
}

}  // namespace umbra

int main(int argc, char** argv) {
  umbra::prepareApplication();
  QApplication application(argc, argv);
  umbra::applyStyle(application);
  umbra::WindowTest test;
  return QTest::qExec(&test, argc, argv);
}
