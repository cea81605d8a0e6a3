// The probe: where it starts, what it says, and what it stays on.
#include <QAbstractItemModel>
#include <QTableView>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "analysis/rays/RayTracedVisibility.h"
#include "tests/window/WindowFixture.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/tables/ProbeTable.h"

namespace umbra {

class ProbingTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void theFirstFrameShowsWhereLightBleeds();
  void theTableAgreesWithTheAnalysis();
  void hoveringProbesAndLeavingKeepsTheProbe();
  void aPinnedProbeStaysOnItsPoint();
  void aHiddenProbeFollowsTheParameters();
};

void ProbingTest::theFirstFrameShowsWhereLightBleeds() {
  MainWindow& window = open();
  const auto& report = window.prober().report();
  QVERIFY(report.has_value());
  QVERIFY(report->pinned);
  QVERIFY(report->probe.reference < 0.1);
  QVERIFY(result("vsm").error > 0.05);
  QVERIFY(!report->footprint.empty());
  QVERIFY(!window.controller().undoStack().canUndo());  // nobody has done anything yet
}

void ProbingTest::theTableAgreesWithTheAnalysis() {
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

void ProbingTest::hoveringProbesAndLeavingKeepsTheProbe() {
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

void ProbingTest::aPinnedProbeStaysOnItsPoint() {
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
  // Two neighbouring pixels may both be nearest to the point.
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
void ProbingTest::aHiddenProbeFollowsTheParameters() {
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

std::unique_ptr<QObject> makeProbingTest() {
  return std::make_unique<ProbingTest>();
}

}  // namespace umbra

#include "ProbingTest.moc"
