// What is not plain about a file is settled in its sheet.
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <cmath>

#include "datasets/maps/ExrFile.h"
#include "datasets/session/file/SessionFile.h"
#include "tests/window/DepthRamp.h"
#include "tests/window/WindowFixture.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/window/CentrePane.h"
#include "ui/window/MessageBanner.h"
#include "ui/window/RunWindow.h"
#include "ui/window/files/ImportSheet.h"

namespace umbra {
namespace {

template <class T>
T& part(MainWindow& window, const char* name) {
  T* found = window.importSheet().findChild<T*>(name);
  if (!found) qFatal("the sheet has no %s", name);
  return *found;
}

QString problemIn(MainWindow& window) {
  auto& label = part<QLabel>(window, "problem");
  return label.isVisible() ? label.text() : QString();
}

QStringList guessesIn(MainWindow& window) {
  QStringList texts;
  for (auto* button : window.importSheet().findChildren<QPushButton*>())
    if (button->isVisible() && button->text() != "Close" && button->text() != "&Close")
      texts << button->text();
  return texts;
}

void pressGuess(MainWindow& window, const QString& text) {
  for (auto* button : window.importSheet().findChildren<QPushButton*>())
    if (button->isVisible() && button->text() == text)
      return QTest::mouseClick(button, Qt::LeftButton);
  qFatal("there is no guess %s", qPrintable(text));
}

void choose(QComboBox& box, const char* text) {
  box.setCurrentIndex(box.findText(text));
  emit box.activated(box.currentIndex());
}

void type(MainWindow& window, const char* field, const char* text) {
  auto& line = part<QLineEdit>(window, field);
  line.setFocus();
  line.selectAll();
  QTest::keyClicks(&line, text);
  QTest::keyClick(&line, Qt::Key_Return);
}

QAction* actionOf(MainWindow& window, const QString& text) {
  for (QAction* action : window.findChildren<QAction*>())
    if (action->text() == text) return action;
  qFatal("there is no action %s", qPrintable(text));
}

}  // namespace

class ImportTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void aRefusedDepthMapBringsUpItsSheet();
  void aRefusedDepthMapOfTheCommandLineBringsUpItsSheet();
  void aDamagedFileHasNoSheet();
  void whatTheSheetSaysIsInTheSession();
  void aProjectionWaitsForItsPlanes();
  void theChannelIsChosen();
  void aMeshIsTurned();
};

void ImportTest::aRefusedDepthMapBringsUpItsSheet() {
  MainWindow& window = open();
  const Document before = window.controller().document();
  window.openFile(writeDepths("far.exr", rampOver(0.7F, 8.0F, 1e10F)));
  QTRY_VERIFY_WITH_TIMEOUT(window.importSheet().isVisible(), patience);
  // The ramp exceeds 1 from its 16th texel on; the row of the background follows.
  QVERIFY2(problemIn(window).startsWith("369 texels"), qPrintable(problemIn(window)));
  QVERIFY(problemIn(window).contains("hold no depth") && !problemIn(window).contains("--"));
  QVERIFY(window.centre().banner().text().isEmpty());
  QVERIFY(window.controller().document().content == before.content);
  const auto bandIs = [&](double low, double high) {
    const auto& plot = window.importSheet().findChild<PlotPane*>()->plot();
    return plot && plot->bands.at(0).low == low && plot->bands.at(0).high == high;
  };
  QVERIFY(bandIs(0.0, 1.0));
  QCOMPARE(guessesIn(window), QStringList({"These saw nothing", "Take this range"}));

  pressGuess(window, "These saw nothing");
  settle();
  QVERIFY(problemIn(window).contains("hold no depth"));  // those beyond the range still do not
  QVERIFY(window.controller().document().content == before.content);
  pressGuess(window, "Take this range");
  untilOpen("far.exr");
  const DepthImport& import = window.controller().session().source.depth;
  QCOMPARE(import.atZero, 0.7);
  QCOMPARE(import.atOne, 8.0);
  QVERIFY((import.miss == DepthMiss{DepthMiss::Kind::Value, 1e10}));
  QVERIFY(problemIn(window).isEmpty() && guessesIn(window).isEmpty());
  QVERIFY(bandIs(0.7, 8.0));
  QVERIFY(part<QLabel>(window, "notes").text().startsWith("24 texels held 1e+10"));
  QCOMPARE((*window.controller().document().content.depth)(0, 0), 0.0);
  QCOMPARE((*window.controller().document().content.depth)(0, 15), 1.0);
  // To open it was one step.
  window.controller().undoStack().undo();
  settle();
  QVERIFY(window.controller().document().content == before.content);
  QVERIFY(!window.controller().undoStack().canUndo());
  QVERIFY(!window.importSheet().isVisible());  // a scene of the catalogue is not read
}

void ImportTest::aRefusedDepthMapOfTheCommandLineBringsUpItsSheet() {
  Workspace workspace;
  workspace.shared.source.kind = SourceKind::DepthFile;
  workspace.shared.source.name = writeDepths("far.exr", rampOver(0.7F, 8.0F, 1e10F));
  window_ = windowOn(workspace);
  window_->show();
  QTRY_VERIFY_WITH_TIMEOUT(window_->importSheet().isVisible(), patience);
  QVERIFY(problemIn(*window_).contains("hold no depth"));
  // What nobody can read still ends the program before a window stands there.
  workspace.shared.source.name = writeFile("letter.exr", "letter");
  QVERIFY_EXCEPTION_THROWN(windowOn(workspace), Error);
}

void ImportTest::aDamagedFileHasNoSheet() {
  MainWindow& window = open();
  window.openFile(writeFile("broken.exr", "this is none"));
  QTRY_VERIFY_WITH_TIMEOUT(window.centre().banner().text().contains("broken.exr"), patience);
  QTest::qWait(300);
  QVERIFY(!window.importSheet().isVisible());
  QVERIFY(window.centre().banner().text().contains("broken.exr"));
}

void ImportTest::whatTheSheetSaysIsInTheSession() {
  MainWindow& window = open();
  QAction* action = actionOf(window, "&How the file is read …");
  QVERIFY(!action->isEnabled());
  window.openFile(writeDepths("plain.exr", rampOver(0.2F, 0.8F, 1.0F)));
  untilOpen("plain.exr");
  QVERIFY(action->isEnabled());
  action->trigger();
  QVERIFY(window.importSheet().isVisible());
  const int steps = window.controller().undoStack().count();
  type(window, "atOne", "2");
  // What is edited while the file is read stays.
  QVERIFY(window.controller().loading());
  window.controller().edit("receiver", [](Session& session) { session.receiver = 0.25; });
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().session().source.depth.atOne, 2.0, patience);
  QVERIFY(std::abs((*window.controller().document().content.depth)(0, 0) - 0.1) < 1e-8);
  QVERIFY(window.importSheet().isVisible());
  QCOMPARE(window.controller().undoStack().count(), steps + 2);
  QCOMPARE(window.controller().session().receiver, std::optional(0.25));
  // A session that is saved brings it back.
  const std::string saved = folder_.filePath("saved.json").toStdString();
  window.saveSession(saved);
  QCOMPARE(readWorkspace(saved).shared.source.depth.atOne, 2.0);

  // What is wrong is told in the sheet, and the map stays.
  const Content content = window.controller().document().content;
  type(window, "atOne", "0");
  QTRY_VERIFY_WITH_TIMEOUT(problemIn(window).contains("is empty"), patience);
  QVERIFY(window.controller().document().content == content);
  QVERIFY(window.centre().banner().text().isEmpty());
  QCOMPARE(part<QLineEdit>(window, "atOne").text(), QString("0"));
  // Undo is of what was read, and the form follows it.
  window.controller().undoStack().undo();
  QCOMPARE(part<QLineEdit>(window, "atOne").text(), QString("1"));
  QVERIFY(problemIn(window).isEmpty());
}

void ImportTest::aProjectionWaitsForItsPlanes() {
  MainWindow& window = open();
  const DepthProjection drawn = projectionFrom("reversed:0.1,100", "test");
  Image<float> depths = rampOver(1.0F, 40.0F, 100.0F);
  for (float& depth : depths.values()) depth = float(drawn.window(double(depth)));
  window.openFile(writeDepths("rev.exr", depths));
  untilOpen("rev.exr");
  window.importSheet().showSheet();
  QTRY_COMPARE_WITH_TIMEOUT(guessesIn(window), QStringList{"Reversed, with near and far"},
                            patience);
  const Content content = window.controller().document().content;
  pressGuess(window, "Reversed, with near and far");
  QVERIFY(problemIn(window).contains("Give both planes"));
  QVERIFY(guessesIn(window).isEmpty());
  QVERIFY(!window.controller().loading());
  type(window, "near", "0.1");
  QVERIFY(problemIn(window).contains("Give both planes"));
  type(window, "far", "100");
  QTRY_VERIFY_WITH_TIMEOUT(window.controller().session().source.depth.projection == drawn,
                           patience);
  QVERIFY(problemIn(window).isEmpty());
  // The distance 1 lies (1 − 0.1) / (100 − 0.1) behind the near plane; floats of window depths near
  // 0.1 keep it to 1e-7.
  const DepthMap& map = *window.controller().document().content.depth;
  QVERIFY(std::abs(map(0, 0) - 0.9 / 99.9) < 1e-7);
  QVERIFY(!(window.controller().document().content == content));
}

void ImportTest::theChannelIsChosen() {
  MainWindow& window = open();
  const std::string file = folder_.filePath("two.exr").toStdString();
  writeExr(file, {{"A", rampOver(0.2F, 0.8F, 1.0F)}, {"B", rampOver(0.3F, 0.6F, 1.0F)}}, {});
  window.openFile(file);
  QTRY_VERIFY_WITH_TIMEOUT(window.importSheet().isVisible(), patience);
  QVERIFY(problemIn(window).contains("there is no channel 'Z'"));
  QVERIFY(!problemIn(window).contains("FILE"));
  auto& channel = part<QComboBox>(window, "channel");
  QVERIFY(channel.isVisible());
  QCOMPARE(channel.count(), 2);
  QCOMPARE(channel.currentIndex(), -1);
  choose(channel, "B");
  untilOpen("two.exr");
  QCOMPARE(window.controller().session().source.depth.channel, std::string("B"));
  QVERIFY(std::abs((*window.controller().document().content.depth)(0, 0) - 0.3) < 1e-7);
  QCOMPARE(channel.currentText(), QString("B"));
  QTRY_VERIFY_WITH_TIMEOUT(window.importSheet().findChild<PlotPane*>()->plot(), patience);
}

void ImportTest::aMeshIsTurned() {
  MainWindow& window = open();
  // A tetrahedron four times as high along z as it is wide.
  window.openFile(writeFile(
      "tall.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
  untilOpen("tall.obj");
  const Content before = window.controller().document().content;
  actionOf(window, "&How the file is read …")->trigger();
  auto& up = part<QComboBox>(window, "up");
  QVERIFY(up.isVisible() && !part<QComboBox>(window, "projection").isVisible());
  up.setCurrentIndex(1);
  emit up.activated(1);
  QTRY_VERIFY_WITH_TIMEOUT(window.controller().session().source.up == UpAxis::Z, patience);
  settle();
  QVERIFY(!(window.controller().document().content == before));
  window.controller().undoStack().undo();
  settle();
  QVERIFY(window.controller().document().content == before);
  QCOMPARE(up.currentIndex(), 0);
}

std::unique_ptr<QObject> makeImportTest() {
  return std::make_unique<ImportTest>();
}

}  // namespace umbra

#include "ImportTest.moc"
