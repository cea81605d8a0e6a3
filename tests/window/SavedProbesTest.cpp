// Probes that are saved under names: their table, their marks, their place in the session.
#include <QAbstractItemModel>
#include <QDockWidget>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "datasets/maps/ExrFile.h"
#include "tests/window/WindowFixture.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/probe/SavedProbes.h"
#include "ui/probe/SavedProbesPane.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/window/CentrePane.h"

namespace umbra {
namespace {

QString cell(MainWindow& window, int row, int column) {
  return window.savedProbesPane().view().model()->index(row, column).data().toString();
}

int columnOf(MainWindow& window, const char* title) {
  const QAbstractItemModel& model = *window.savedProbesPane().view().model();
  for (int column = 0; column < model.columnCount(); ++column)
    if (model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString() == title)
      return column;
  return -1;
}

double errorAt(MainWindow& window, int row, const char* technique) {
  return window.savedProbes().rows().at(std::size_t(row)).figures->of(technique)->error;
}

QPoint middleOf(QTableView& view, int row, int column) {
  return view.visualRect(view.model()->index(row, column)).center();
}

Camera turnedAround(const Camera& camera) {
  Camera turned = camera;
  turned.target = 2.0 * camera.position - camera.target;
  return turned;
}

}  // namespace

class SavedProbesTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void savedProbesStayOnTheirPoints();
  void aSavedProbeIsGoneToRenamedAndDeleted();
  void savedProbesAreOpenedAgain();
  void aSavedProbeOutOfSightIsGoneTo();
  void savedTexelsAreOfTheirFile();
  void savedFiguresHideBehindAVeil();

 private:
  // Settles, and waits until every saved probe has been read.
  void settleSaved();
};

void SavedProbesTest::settleSaved() {
  settle();
  QTRY_VERIFY_WITH_TIMEOUT(window_->savedProbes().upToDate(), patience);
}

void SavedProbesTest::savedProbesStayOnTheirPoints() {
  MainWindow& window = open();
  QVERIFY(window.savedProbesPane().saveButton().isEnabled());
  const Eigen::Vector3d first = *window.prober().report()->point;
  const double firstError = result("vsm").error;
  key(Qt::Key_K);
  QVERIFY(!window.savedProbesPane().saveButton().isEnabled());  // it is saved already
  const QSize size = window.view().pixels();
  click({size.width() / 2, size.height() * 4 / 5});
  const double secondError = result("vsm").error;
  key(Qt::Key_K);
  settleSaved();

  const std::vector<NamedProbe>& probes = window.controller().session().probes;
  QCOMPARE(int(probes.size()), 2);
  QCOMPARE(*probes[0].point, first);
  QCOMPARE(window.savedProbes().current(), 1);
  // The table says what the probe's own panes say.
  QCOMPARE(errorAt(window, 0, "vsm"), firstError);
  QCOMPARE(errorAt(window, 1, "vsm"), secondError);
  QCOMPARE(cell(window, 1, columnOf(window, "VSM")),
           QString::number(result("vsm").visibility, 'f', 3));
  QCOMPARE(cell(window, 1, columnOf(window, "Reference")),
           QString::number(window.prober().report()->probe.reference, 'f', 3));

  // Half a pixel's way changes what the pixel shows, and nothing of the point.
  const Camera camera = window.controller().document().content.scene->camera;
  Camera moved = camera;
  moved.position += 0.02 * (camera.target - camera.position).cross(camera.up);
  emit window.view().cameraMoved(moved);
  settleSaved();
  QCOMPARE(errorAt(window, 0, "vsm"), firstError);
  QVERIFY(!window.savedProbes().rows()[0].hidden);
  QCOMPARE(result("vsm").error, secondError);

  emit window.view().cameraMoved(turnedAround(camera));
  settleSaved();
  QCOMPARE(errorAt(window, 0, "vsm"), firstError);
  QVERIFY(window.savedProbes().rows()[0].hidden);
  QCOMPARE(*window.controller().session().probes[0].point, first);
  // Both marks keep to their points, wherever these are seen: the current one is the probe's own.
  QCOMPARE(int(window.view().overlayContents().marks.size()), 1);
  QCOMPARE(window.view().overlayContents().marks[0].point, first);
  QCOMPARE(window.view().overlayContents().marks[0].number, 1);

  window.controller().edit(
      "Reduce", [](Session& session) { session.parameters["vsm"]["bleed-reduction"] = 0.9; });
  settleSaved();
  QVERIFY(errorAt(window, 0, "vsm") < firstError);
}

void SavedProbesTest::aSavedProbeIsGoneToRenamedAndDeleted() {
  MainWindow& window = open();
  window.findChild<QDockWidget*>("probesDock")->raise();
  settle();
  const Eigen::Vector3d first = *window.prober().report()->point;
  key(Qt::Key_K);
  const QSize size = window.view().pixels();
  click({size.width() / 2, size.height() * 4 / 5});
  key(Qt::Key_K);
  settleSaved();
  QTableView& view = window.savedProbesPane().view();
  QVERIFY(view.isVisible());

  QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, middleOf(view, 0, 1));
  settleSaved();
  QCOMPARE(window.savedProbes().current(), 0);
  QCOMPARE(*window.prober().pinnedPoint(), first);
  QCOMPARE(result("vsm").error, errorAt(window, 0, "vsm"));

  window.savedProbesPane().editName(0);
  auto* editor = view.viewport()->findChild<QLineEdit*>();
  QVERIFY(editor);
  editor->setText("Under the \"bench\"");
  QTest::keyClick(editor, Qt::Key_Return);
  QTRY_COMPARE_WITH_TIMEOUT(cell(window, 0, 0), QString("Under the \"bench\""), patience);
  QCOMPARE(window.controller().session().keptProbe, std::string("Under the \"bench\""));
  QCOMPARE(*window.prober().pinnedPoint(), first);

  const Session before = window.controller().session();
  view.setFocus();
  QTest::keyClick(&view, Qt::Key_Delete);
  settleSaved();
  QCOMPARE(int(window.controller().session().probes.size()), 1);
  QCOMPARE(view.model()->rowCount(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(window.controller().session() == before);
  key(Qt::Key_Z, Qt::ControlModifier);  // the name
  QVERIFY(cell(window, 0, 0) != "Under the \"bench\"");
  QCOMPARE(*window.prober().pinnedPoint(), first);
  key(Qt::Key_Z, Qt::ControlModifier);  // the way there
  QCOMPARE(window.savedProbes().current(), 1);
  key(Qt::Key_Y, Qt::ControlModifier);
  settleSaved();
  QCOMPARE(*window.prober().pinnedPoint(), first);

  // A name that another has is refused, and said so.
  const std::vector<NamedProbe> probes = window.controller().session().probes;
  window.savedProbes().rename(0, QString::fromStdString(probes[1].name));
  QVERIFY(window.controller().session().probes == probes);
}

void SavedProbesTest::savedProbesAreOpenedAgain() {
  MainWindow& window = open();
  key(Qt::Key_K);
  settleSaved();
  const Workspace saved = window.sessionToSave();
  const double error = errorAt(window, 0, "vsm");
  const QString file = folder_.filePath("saved.json");
  window.saveSession(file.toStdString());
  SceneSource other;
  other.name = "three-planes";
  window.controller().openSource(other);
  settleSaved();
  QVERIFY(window.controller().session().probes.empty());  // of another scene
  QCOMPARE(window.savedProbesPane().view().model()->rowCount(), 0);
  key(Qt::Key_Z, Qt::ControlModifier);
  settleSaved();
  QCOMPARE(window.savedProbesPane().view().model()->rowCount(), 1);
  key(Qt::Key_Y, Qt::ControlModifier);
  settle();
  window.openFile(file.toStdString());
  settleSaved();
  QVERIFY(window.controller().session().probes == saved.shared.probes);
  QCOMPARE(window.savedProbes().current(), 0);
  QCOMPARE(errorAt(window, 0, "vsm"), error);
  QCOMPARE(result("vsm").error, error);

  QVERIFY(window.savedProbesPane().asText(',').startsWith("name,x,y,z,receiver,truth,"));
  QVERIFY(window.savedProbesPane().asText('\t').contains(
      QString::fromStdString(saved.shared.probes[0].name) + "\t"));
}

// Nobody has seen the point in this window: it is read from its surface.
void SavedProbesTest::aSavedProbeOutOfSightIsGoneTo() {
  MainWindow& window = open();
  key(Qt::Key_K);
  settleSaved();
  Session away = sessionOf(window.sessionToSave());
  const double truth = window.prober().report()->probe.reference;
  const double receiver = window.prober().report()->probe.receiver;
  away.camera = turnedAround(window.controller().document().content.scene->camera);
  open(away);
  settleSaved();
  const SavedProbes::Row& row = window_->savedProbes().rows().at(0);
  QVERIFY(row.hidden);
  QVERIFY(row.figures.has_value());
  // Its place on the map is known to 2⁻²⁴ of the map and the digits of the depth buffer: a
  // thousandth of a texel, by which the taps at two edges weigh more or less.
  QVERIFY(std::abs(row.figures->reference - truth) < 2e-3);
  // The picture's surface is known to the digits of its depth buffer.
  QVERIFY(std::abs(row.figures->receiver - receiver) < 1e-4);
  QVERIFY(window_->prober().report().has_value());
  QCOMPARE(window_->prober().report()->probe.receiver, row.figures->receiver);
  QVERIFY(!result("vsm").gpu);

  window_->controller().edit(
      "Trilinear", [](Session& session) { session.frame.read.filter = ReadFilter::Trilinear; });
  settleSaved();
  QVERIFY(!window_->savedProbes().rows().at(0).figures);
  QCOMPARE(window_->savedProbes().rows().at(0).reason, QString("not in sight"));
}

void SavedProbesTest::savedTexelsAreOfTheirFile() {
  MainWindow& window = open();
  Image<float> depths(48, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 48; ++x) depths(x, y) = float((x * 7 + y * 13) % 50) / 50.0F;
  const QString file = folder_.filePath("saved.exr");
  writeExr(file.toStdString(), {{"Z", depths}}, {});
  window.openFile(file.toStdString());
  QTRY_VERIFY_WITH_TIMEOUT(window.controller().document().content.depth != nullptr, patience);
  emit window.centre().depthView().texelClicked(5, 20);
  window.controller().edit("receiver", [](Session& session) { session.receiver = 0.4; });
  window.savedProbes().save();
  QVERIFY(!window.savedProbes().canSave());
  window.controller().edit("receiver", [](Session& session) { session.receiver = 0.6; });
  QVERIFY(window.savedProbes().canSave());  // the same texel, another depth
  emit window.centre().depthView().texelClicked(30, 11);
  settleSaved();
  const NamedProbe saved = window.controller().session().probes.at(0);
  QVERIFY(saved.texel == (Pixel{5, 20}));
  QVERIFY(!saved.point);
  QCOMPARE(*saved.receiver, 0.4);
  window.savedProbes().goTo(0);
  settleSaved();
  QVERIFY(window.prober().report()->pixel == (Pixel{5, 20}));
  QCOMPARE(errorAt(window, 0, "vsm"), result("vsm").error);
}

void SavedProbesTest::savedFiguresHideBehindAVeil() {
  MainWindow& window = open();
  window.findChild<QDockWidget*>("probesDock")->raise();
  key(Qt::Key_K);
  settleSaved();
  SavedProbesPane& pane = window.savedProbesPane();
  QVERIFY(pane.view().isVisible());
  window.prober().setVeil("Predict first");
  QVERIFY(!pane.view().isVisible());
  QVERIFY(pane.asText('\t').isEmpty());
  window.prober().setVeil({});
  QTRY_VERIFY_WITH_TIMEOUT(pane.view().isVisible(), patience);
  QVERIFY(!pane.asText('\t').isEmpty());
}

std::unique_ptr<QObject> makeSavedProbesTest() {
  return std::make_unique<SavedProbesTest>();
}

}  // namespace umbra

#include "SavedProbesTest.moc"
