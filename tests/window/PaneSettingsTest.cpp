// Panes with settings of their own.
#include <QTest>
#include <cmath>

#include "datasets/session/PaneChoice.h"
#include "datasets/session/PaneEditing.h"
#include "tests/window/Pictures.h"
#include "tests/window/WindowFixture.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/panes/PaneHeader.h"
#include "ui/panes/PaneMenu.h"
#include "ui/panes/PanePictures.h"
#include "ui/picture/SceneView.h"
#include "ui/picture/TechniquePicture.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/FrameSettingsForm.h"
#include "ui/window/CentrePane.h"
#include "ui/window/ControlPane.h"

namespace umbra {
namespace {

// Sets the radius as the slider does.
void setRadius(MainWindow& window, int radius) {
  FrameSettings frame = window.controls().frame().settings();
  frame.kernel.radius = radius;
  emit window.controls().frame().settingsChanged(frame, "radius");
  emit window.controls().frame().editingFinished("radius");
}

int shownRadius(MainWindow& window) {
  return window.controls().frame().settings().kernel.radius;
}

void chooseIn(PaneMenu& menu, const QString& text) {
  emit menu.aboutToShow();
  for (QMenu* place : QList<QMenu*>{&menu} + menu.findChildren<QMenu*>())
    for (QAction* action : place->actions())
      if (action->text().remove('&') == text) return action->trigger();
  QFAIL(qPrintable(text));
}

}  // namespace

class PaneSettingsTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void aDuplicateIsDrawnWithItsOwnSettings();
  void anotherPaneBringsItsSettingsToTheControls();
  void aPanesErrorIsOfItsOwnSettings();
  void panesShareTheLiveViewsDepthMap();
  void aPanesMenuSharesAndCloses();
  void whatPanesShowIsKept();
  void panesWithSettingsAreSavedAndOpened();
};

void PaneSettingsTest::aDuplicateIsDrawnWithItsOwnSettings() {
  MainWindow& window = open(comparing(ComparisonMode::Wipe, {"vsm", "pcf"}));
  window.resize(1650, 900);  // room for labels of one line, whatever they say
  ComparisonPanes& panes = window.centre().comparison();
  settlePanes();
  // The live view with the narrow kernel, before the copy gets a wider one.
  const QImage narrow = liveFrame(window);
  setRadius(window, 12);
  settlePanes();
  const QImage wide = liveFrame(window);
  QVERIFY(wide != narrow);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_D, Qt::ControlModifier);
  setRadius(window, 12);
  settlePanes();
  const std::vector<std::string> both{"vsm", "vsm"};
  QVERIFY(panes.shown() == both);
  QCOMPARE(panes.active(), std::size_t(1));
  QCOMPARE(panes.header(0).differences(), QString("radius 3"));
  QCOMPARE(panes.header(1).differences(), QString("radius 12"));
  QCOMPARE(liveFrame(window).size(), wide.size());
  QVERIFY(liveFrame(window) == wide);
  QVERIFY(bare(window.view().overlayContents().curtain) == narrow);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  settlePanes();
  const std::vector<std::string> before{"vsm", "pcf"};
  QVERIFY(panes.shown() == before);
  QVERIFY(panes.header(0).differences().isEmpty());
}

void PaneSettingsTest::anotherPaneBringsItsSettingsToTheControls() {
  Workspace workspace = comparing(ComparisonMode::Single, {"vsm", "msm"});
  workspace.comparison.panes.clear();
  MainWindow& window = open(workspace);
  ComparisonPanes& panes = window.centre().comparison();
  key(Qt::Key_D, Qt::ControlModifier);
  setRadius(window, 12);
  settlePanes();
  QCOMPARE(panes.shown().size(), std::size_t(2));
  QVERIFY(panes.picture(0).isVisible());
  const QImage narrow = panes.picture(0).picture();
  QVERIFY(!narrow.isNull());
  QVERIFY(bare(narrow) != liveFrame(window));
  QCOMPARE(shownRadius(window), 12);

  QTest::mouseClick(&panes.picture(0), Qt::LeftButton);
  settlePanes();
  QCOMPARE(panes.active(), std::size_t(0));
  QCOMPARE(shownRadius(window), 3);
  QCOMPARE(panes.header(1).differences(), QString("radius 12"));
  setRadius(window, 5);
  QCOMPARE(panes.header(0).differences(), QString("radius 5"));
  QCOMPARE(panes.header(1).differences(), QString("radius 12"));

  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(panes.active(), std::size_t(1));
  QCOMPARE(shownRadius(window), 12);
  settlePanes();
  QVERIFY(panes.picture(0).picture() == narrow);
}

void PaneSettingsTest::aPanesErrorIsOfItsOwnSettings() {
  // A wipe's sides are of one size: the probe is in the same pixel of both.
  Workspace workspace = comparing(ComparisonMode::Wipe, {"vsm", "vsm"});
  setLinked(workspace, 1, false);
  workspace.comparison.panes[1].own.values["kernel.radius"] = 14;
  workspace.comparison.panes[1].own.values["map.size"] = 512;
  workspace.comparison.panes[1].own.values["cascades.count"] = 2;
  MainWindow& window = open(workspace);
  settlePanes();
  ComparisonPanes& panes = window.centre().comparison();
  const auto errorOf = [&](std::size_t pane) {
    return panes.figures(pane) ? panes.figures(pane)->result.error : std::nan("");
  };
  const double linked = errorOf(0), own = errorOf(1);
  QCOMPARE(linked, result("vsm").error);
  QCOMPARE(panes.header(0).errorText(), style::signedFigure(linked));
  QCOMPARE(panes.header(1).errorText(), style::signedFigure(own));
  QVERIFY(panes.header(1).errorText() != panes.header(0).errorText());
  QVERIFY(panes.figures(0)->footprint.empty());
  QVERIFY(!panes.figures(1)->footprint.empty());
  // A pane must tell the same figures when it is the active one and when the other one is.
  // Receivers are floats, read back from frames of two renderers.
  constexpr double rounding = 1e-6;
  QTest::mouseClick(&panes.header(1), Qt::LeftButton, {}, QPoint(2, 2));
  settlePanes();
  QCOMPARE(panes.active(), std::size_t(1));
  QVERIFY(std::abs(result("vsm").error - own) < rounding);
  QVERIFY(std::abs(errorOf(1) - own) < rounding);
  QVERIFY(std::abs(errorOf(0) - linked) < rounding);
  QVERIFY(panes.figures(1)->footprint.empty());
}

// What a pane is probed in is a frame of its own, but for the depths where the live view has them.
void PaneSettingsTest::panesShareTheLiveViewsDepthMap() {
  Workspace workspace = comparing(ComparisonMode::Grid, {"vsm", "vsm", "vsm"});
  for (std::size_t pane : {1, 2}) setLinked(workspace, pane, false);
  workspace.comparison.panes[1].own.values["kernel.radius"] = 14;
  workspace.comparison.panes[2].own.values["map.size"] = 512;
  MainWindow& window = open(workspace);
  window.resize(1650, 900);  // labels of one line, which leave the pictures their size
  settlePanes();
  const auto* pictures = window.findChild<PanePictures*>();
  const auto frameOf = [&](std::size_t pane) { return pictures->current(pane)->frame; };
  const auto live = window.view().lastFrame()->sharedDepthMap();
  QCOMPARE(frameOf(1)->settings.kernel.radius, 14);
  QVERIFY(frameOf(1)->maps.front() == live);
  QVERIFY(frameOf(2)->maps.front() != live);
  QCOMPARE(frameOf(2)->maps.front()->width(), 512);
  // Another map in the live view leaves the pane the one that its frame was drawn with.
  const auto before = frameOf(1);
  window.controller().edit("Smaller map", [](Session& s) { s.frame.map.size = 256; });
  settlePanes();
  QCOMPARE(window.view().lastFrame()->depthMap().width(), 256);
  QVERIFY(frameOf(1) == before);
  QCOMPARE(before->maps.front()->width(), 1024);
}

void PaneSettingsTest::aPanesMenuSharesAndCloses() {
  MainWindow& window = open(comparing(ComparisonMode::Grid, {"vsm", "msm", "pcf"}));
  ComparisonPanes& panes = window.centre().comparison();
  chooseIn(panes.menu(1), "Duplicate this pane");
  setRadius(window, 12);
  QCOMPARE(panes.header(2).differences(), QString("radius 12"));
  chooseIn(panes.menu(0), "Same settings as the active pane");
  QCOMPARE(panes.header(0).differences(), QString("radius 12"));
  QCOMPARE(panes.header(3).differences(), QString("radius 3"));
  chooseIn(panes.menu(2), "Kernel and radius");
  QCOMPARE(shownRadius(window), 3);
  chooseIn(panes.menu(2), "Close this pane");
  const std::vector<std::string> left{"vsm", "msm", "pcf"};
  QVERIFY(panes.shown() == left);
  chooseIn(panes.menu(0), "Share settings with the other panes");
  QVERIFY(panes.header(0).differences().isEmpty());
  for (int i = 0; i < 6; ++i) key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(panes.shown() == left);
  QCOMPARE(window.controller().undoStack().index(), 0);
  settlePanes();
}

// Two panes show the oldest of the pictures that are kept: one more picture drives neither out.
void PaneSettingsTest::whatPanesShowIsKept() {
  MainWindow& window = open(comparing(ComparisonMode::Grid, {"vsm", "msm", "pcf"}));
  ComparisonPanes& panes = window.centre().comparison();
  settlePanes();
  const QImage first = panes.picture(1).picture();
  for (int radius : {4, 5, 6}) {
    setRadius(window, radius);
    settlePanes();
  }
  for (int i = 0; i < 3; ++i) key(Qt::Key_Z, Qt::ControlModifier);
  settlePanes();
  QCOMPARE(panes.picture(1).picture().cacheKey(), first.cacheKey());  // not drawn again
  window.controller().editPanes("Choose",
                                [](Workspace& workspace) { choosePane(workspace, 2, "hard"); });
  settlePanes();
  QCOMPARE(panes.picture(1).picture().cacheKey(), first.cacheKey());
}

void PaneSettingsTest::panesWithSettingsAreSavedAndOpened() {
  MainWindow& window = open(comparing(ComparisonMode::Grid, {"vsm", "msm"}));
  key(Qt::Key_D, Qt::ControlModifier);
  setRadius(window, 12);
  settlePanes();
  const QString file = folder_.filePath("own-settings.json");
  window.saveSession(file.toStdString());
  const Workspace saved = window.sessionToSave();
  key(Qt::Key_F8);
  setRadius(window, 1);
  window.openFile(file.toStdString());
  QTRY_VERIFY_WITH_TIMEOUT(window.controller().workspace() == saved, patience);
  settlePanes();
  ComparisonPanes& panes = window.centre().comparison();
  const std::vector<std::string> shown{"vsm", "vsm", "msm"};
  QVERIFY(panes.shown() == shown);
  QCOMPARE(panes.active(), std::size_t(1));
  QCOMPARE(shownRadius(window), 12);
  QCOMPARE(panes.header(1).differences(), QString("radius 12"));
}

std::unique_ptr<QObject> makePaneSettingsTest() {
  return std::make_unique<PaneSettingsTest>();
}

}  // namespace umbra

#include "PaneSettingsTest.moc"
