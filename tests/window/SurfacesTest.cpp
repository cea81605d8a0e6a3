// Bleeding written onto the mesh.
#include <QFile>
#include <QSignalSpy>
#include <QTest>
#include <optional>

#include "analysis/surfaces/SurfaceErrors.h"
#include "datasets/meshes/MeshFile.h"
#include "filters/core/support/Error.h"
#include "tests/window/WindowFixture.h"
#include "ui/errors/SurfaceExport.h"
#include "ui/picture/SceneView.h"
#include "ui/window/CentrePane.h"
#include "ui/window/MessageBanner.h"

namespace umbra {
namespace {

// The mean of max(error, 0) over all surfaces, as the analysis has it.
SurfaceSummary expectedSummary(MainWindow& window) {
  ShadowRenderer& frame = *window.view().lastFrame();
  const Session& session = window.controller().session();
  const auto technique = window.controller().technique().clone();
  technique->adapt(frame.depthMap());
  const Scene& scene = *window.controller().document().content.scene;
  const LightFrame light = frame.lightFrame();
  return surfaceErrors(surfaceMeshOf(scene, light, session.frame.map.size),
                       {scene, light, frame.depthMap(), session.frame, *technique})
      .summary;
}

}  // namespace

class SurfacesTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void bleedingIsWrittenOntoTheMesh();
  void aCancelledMeshLeavesWhatWasThere();
  void whatHasNoSurfacesIsRefused();
};

void SurfacesTest::bleedingIsWrittenOntoTheMesh() {
  Session session;
  session.source.name = "three-planes";
  session.frame.map.size = 256;
  MainWindow& window = open(session);
  const SurfaceSummary expected = expectedSummary(window);
  QVERIFY(expected.all.bleedingArea > 0.0);
  for (const char* name : {"bleeding.ply", "bleeding.vtp"}) {
    QSignalSpy progressed(&window.surfaces(), &SurfaceExport::progressed);
    std::optional<SurfaceSummary> summary;
    const auto noted = connect(&window.surfaces(), &SurfaceExport::written, this,
                               [&](const QString&, const SurfaceSummary& s) { summary = s; });
    const QString file = folder_.filePath(name);
    window.exportBleeding(file.toStdString());
    QVERIFY(window.surfaces().busy());
    QVERIFY(QTest::qWaitFor([&] { return summary.has_value(); }, patience));
    disconnect(noted);
    QVERIFY(!window.surfaces().busy());
    QVERIFY(progressed.count() >= 2);
    QCOMPARE(progressed.last()[0].toInt(), 100);
    QCOMPARE(summary->all.bleedingArea, expected.all.bleedingArea);
    QCOMPARE(summary->all.meanBleeding, expected.all.meanBleeding);
    QVERIFY(window.centre().banner().text().contains(name));
    QVERIFY(QFile::exists(file));
    settle();  // the banner takes some of the picture's room
  }
  const Mesh mesh = readMeshFile(folder_.filePath("bleeding.ply").toStdString());
  QCOMPARE(mesh.triangles.size(), expected.all.faces);
}

void SurfacesTest::aCancelledMeshLeavesWhatWasThere() {
  Session session;
  session.source.name = "three-planes";
  MainWindow& window = open(session);
  const QString file = folder_.filePath("kept.ply");
  QFile kept(file);
  QVERIFY(kept.open(QIODevice::WriteOnly));
  kept.write("kept");
  kept.close();
  QSignalSpy cancelled(&window.surfaces(), &SurfaceExport::cancelled);
  window.exportBleeding(file.toStdString());
  window.surfaces().cancel();
  QVERIFY(QTest::qWaitFor([&] { return cancelled.count() == 1; }, patience));
  QVERIFY(kept.open(QIODevice::ReadOnly));
  QCOMPARE(kept.readAll(), QByteArray("kept"));
}

void SurfacesTest::whatHasNoSurfacesIsRefused() {
  Session session;
  session.source.name = "three-planes";
  MainWindow& window = open(session);
  const auto refusal = [&](const char* name) {
    try {
      window.exportBleeding(folder_.filePath(name).toStdString());
    } catch (const Error& error) {
      return QString::fromUtf8(error.what());
    }
    return QString();
  };
  QVERIFY(refusal("mesh.obj").contains("is written as .vtp or .ply"));
  window.controller().edit("cascades", [](Session& s) { s.frame.map.cascades.count = 2; });
  settle();
  QVERIFY(refusal("mesh.vtp").contains("take one map"));
  window.controller().edit("filter", [](Session& s) {
    s.frame.map.cascades.count = 1;
    s.frame.read.filter = ReadFilter::Trilinear;
  });
  settle();
  QVERIFY(refusal("mesh.vtp").contains("take bilinear"));
  QVERIFY(!QFile::exists(folder_.filePath("mesh.vtp")));
}

std::unique_ptr<QObject> makeSurfacesTest() {
  return std::make_unique<SurfacesTest>();
}

}  // namespace umbra

#include "SurfacesTest.moc"
