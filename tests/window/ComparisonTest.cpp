// Techniques beside each other.
#include <QComboBox>
#include <QMouseEvent>
#include <QTest>
#include <cmath>

#include "datasets/maps/ExrFile.h"
#include "datasets/session/PaneEditing.h"
#include "datasets/session/file/SessionFile.h"
#include "tests/window/Pictures.h"
#include "tests/window/WindowFixture.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/panes/PaneHeader.h"
#include "ui/panes/WipeHandle.h"
#include "ui/picture/SceneView.h"
#include "ui/picture/TechniquePicture.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/window/CentrePane.h"

namespace umbra {

class ComparisonTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void aWipeIsDragged();
  void aWipesSidesStayWhereTheyAre();
  void panesAreLabelledWithTheirErrorAtTheProbe();
  void aClickedPaneIsTheSessions();
  void whatAPaneCannotShowIsSaidThere();
  void aDepthFileTakesThePlaceOfPanes();
};

void ComparisonTest::aWipeIsDragged() {
  MainWindow& window = open(comparing(ComparisonMode::Wipe, {"vsm", "pcf"}));
  settlePanes();
  WipeHandle& wipe = window.centre().comparison().wipe();
  QVERIFY(wipe.isVisible());
  const auto position = [&] { return window.controller().workspace().comparison.wipe; };
  const auto middle = [&] { return double(wipe.geometry().center().x()) / window.view().width(); };
  const double pixel = 1.0 / window.view().width();
  QVERIFY(std::abs(middle() - 0.5) <= pixel);
  const Camera camera = window.view().lastFrame()->camera();
  const auto grip = wipe.rect().center();
  QTest::mousePress(&wipe, Qt::LeftButton, {}, grip);
  for (int step = 0; step < 4; ++step) {
    const QPoint to = grip + QPoint(-30, 0);
    QMouseEvent move(QEvent::MouseMove, to, wipe.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&wipe, &move);
  }
  QTest::mouseRelease(&wipe, Qt::LeftButton, {}, grip);
  settlePanes();
  // The handle went with the pointer: 30 pixels each time, to the pixel that it is rounded to.
  QVERIFY(std::abs(position() - (0.5 - 120.0 * pixel)) <= 4.0 * pixel);
  QVERIFY(std::abs(middle() - position()) <= pixel);
  QVERIFY(window.view().lastFrame()->camera() == camera);
  QCOMPARE(window.controller().undoStack().count(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(position(), 0.5);
  QVERIFY(std::abs(middle() - 0.5) <= pixel);
  key(Qt::Key_F8);
  QVERIFY(!wipe.isVisible());
  QVERIFY(window.view().overlayContents().curtain.isNull());
}

void ComparisonTest::aWipesSidesStayWhereTheyAre() {
  MainWindow& window = open(comparing(ComparisonMode::Wipe, {"vsm", "pcf"}));
  settlePanes();
  ComparisonPanes& panes = window.centre().comparison();
  const std::vector<std::string> shown = panes.shown();
  const QImage left = liveFrame(window);
  const QImage right = bare(window.view().overlayContents().curtain);
  QCOMPARE(right.size(), left.size());
  QVERIFY(right != left);
  QVERIFY(!window.view().overlayContents().curtainLeft);
  // A key makes the right pane the live one.
  key(Qt::Key_1);
  settlePanes();
  QCOMPARE(window.controller().session().technique, std::string("pcf"));
  QCOMPARE(panes.active(), std::size_t(1));
  QVERIFY(panes.shown() == shown);
  QVERIFY(liveFrame(window) == right);
  QVERIFY(bare(window.view().overlayContents().curtain) == left);
  QVERIFY(window.view().overlayContents().curtainLeft);
  // A click on its label makes the left pane the live one again.
  QTest::mouseClick(&panes.header(0), Qt::LeftButton, {}, QPoint(2, 2));
  settlePanes();
  QCOMPARE(panes.active(), std::size_t(0));
  QVERIFY(liveFrame(window) == left);
}

void ComparisonTest::panesAreLabelledWithTheirErrorAtTheProbe() {
  const std::vector<std::string> techniques{"vsm", "lvsm", "pcf"};
  MainWindow& window = open(comparing(ComparisonMode::Grid, techniques));
  settlePanes();
  ComparisonPanes& panes = window.centre().comparison();
  QVERIFY(panes.shown() == techniques);
  const auto labelled = [&] {
    for (std::size_t i = 0; i < techniques.size(); ++i) {
      if (!panes.header(i).isVisible()) return false;
      if (panes.header(i).technique() != style::text(techniques[i])) return false;
      if (panes.header(i).errorText() != style::signedFigure(result(techniques[i].c_str()).error))
        return false;
    }
    return true;
  };
  QVERIFY(labelled());
  QCOMPARE(panes.header(2).errorText(), QString("+0.000"));  // it is the truth
  QVERIFY(panes.header(0).errorText() != panes.header(2).errorText());
  // Pointing at another pane probes the same pixel of all.
  key(Qt::Key_Escape);
  QVERIFY(panes.header(0).errorText().isEmpty());
  const QSize size = window.view().pixels();
  emit panes.picture(1).hovered(Pixel{size.width() / 2, size.height() * 4 / 5});
  QTRY_VERIFY_WITH_TIMEOUT(window.prober().report().has_value(), patience);
  QVERIFY(labelled());
}

void ComparisonTest::aClickedPaneIsTheSessions() {
  const std::vector<std::string> techniques{"vsm", "pcf", "hard", "msm", "esm", "lvsm"};
  MainWindow& window = open(comparing(ComparisonMode::Grid, techniques));
  settlePanes();
  ComparisonPanes& panes = window.centre().comparison();
  QVERIFY(!panes.picture(0).isVisible());
  QTest::mouseClick(&panes.picture(1), Qt::LeftButton);
  settlePanes();
  QCOMPARE(window.controller().session().technique, std::string("pcf"));
  QVERIFY(panes.shown() == techniques);
  for (std::size_t i = 0; i < techniques.size();
       ++i)  // of one width, but for its division by three
    QVERIFY(std::abs(panes.header(i).width() - panes.header(0).width()) <= 1);
  QVERIFY(!panes.picture(1).isVisible());
  QVERIFY(panes.picture(0).isVisible());
  QCOMPARE(window.view().x(), panes.header(1).x());
  QCOMPARE(window.view().width(), panes.header(1).width());
  // A technique that no pane has takes the live pane's place; undo brings both back.
  key(Qt::Key_8);
  settlePanes();
  std::vector<std::string> exchanged = techniques;
  exchanged[1] = "power-cdf";
  QVERIFY(panes.shown() == exchanged);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  settlePanes();
  QCOMPARE(window.controller().session().technique, std::string("vsm"));
  QVERIFY(panes.shown() == techniques);
  QVERIFY(!panes.picture(0).isVisible());
}

void ComparisonTest::whatAPaneCannotShowIsSaidThere() {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "power-cdf"});
  workspace.shared.frame.read.filter = ReadFilter::SummedArea;
  MainWindow& window = open(workspace);
  settlePanes();
  ComparisonPanes& panes = window.centre().comparison();
  QVERIFY(window.controller().refusals().contains("power-cdf"));
  QVERIFY(panes.picture(1).picture().isNull());
  QCOMPARE(panes.picture(1).message(), window.controller().refusals().value("power-cdf"));
  // A technique is not offered where it cannot be drawn either.
  const auto* box = panes.header(0).findChild<QComboBox*>();
  const QModelIndex refused = box->model()->index(box->findData("power-cdf"), 0);
  QVERIFY(!(refused.flags() & Qt::ItemIsEnabled));
  QVERIFY(box->model()->index(box->findData("msm"), 0).flags() & Qt::ItemIsEnabled);
  // A pane with another read is refused no technique, and the other panes are refused none because
  // of it.
  window.controller().editPanes("Read otherwise", [](Workspace& w) {
    setOwn(w, 1, PaneSetting::Read, true);
    w.comparison.panes[1].own.values["read.filter"] = std::string("bilinear");
  });
  settlePanes();
  QVERIFY(!panes.picture(1).picture().isNull());
  key(Qt::Key_Z, Qt::ControlModifier);
  settlePanes();
  QVERIFY(panes.picture(1).picture().isNull());
  window.controller().edit("Read texels",
                           [](Session& s) { s.frame.read.filter = ReadFilter::Bilinear; });
  settlePanes();
  QVERIFY(!panes.picture(1).picture().isNull());
  QVERIFY(panes.picture(1).message().isEmpty());
}

void ComparisonTest::aDepthFileTakesThePlaceOfPanes() {
  MainWindow& window = open(comparing(ComparisonMode::Grid, {"vsm", "pcf"}));
  settlePanes();
  const QString file = folder_.filePath("beside-panes.exr");
  writeExr(file.toStdString(), {{"Z", Image<float>(24, 16, 1, 0.5F)}}, {});
  // This session has a probe from the start, and settings that no pane has.
  Session session;
  session.source.kind = SourceKind::DepthFile;
  session.source.name = file.toStdString();
  session.frame.kernel.radius = 8;
  session.probe = Pixel{12, 8};
  const QString saved = folder_.filePath("beside-panes.json");
  writeWorkspace({session}, saved.toStdString());
  window.openFile(saved.toStdString());
  QTRY_VERIFY_WITH_TIMEOUT(window.controller().document().content.depth != nullptr, patience);
  QVERIFY(window.centre().depthView().isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(window.controller().document().content.scene != nullptr);
  settlePanes();
  QVERIFY(window.centre().comparison().picture(1).isVisible());
}

std::unique_ptr<QObject> makeComparisonTest() {
  return std::make_unique<ComparisonTest>();
}

}  // namespace umbra

#include "ComparisonTest.moc"
