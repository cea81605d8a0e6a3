// Files are opened in every way, and name their texels themselves.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QUrl>

#include "datasets/maps/ExrFile.h"
#include "datasets/session/file/SessionInExr.h"
#include "tests/window/DepthRamp.h"
#include "tests/window/WindowFixture.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/SavedProbes.h"
#include "ui/probe/SavedProbesPane.h"
#include "ui/widgets/maps/ColourBar.h"
#include "ui/widgets/maps/ShadowMapCanvas.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/widgets/tables/RegionTable.h"
#include "ui/window/CentrePane.h"
#include "ui/window/MessageBanner.h"
#include "ui/window/files/RecentFiles.h"
#include "ui/window/menus/RecentMenu.h"

namespace umbra {
namespace {

// Where a drop onto the middle of the picture goes to, as Qt finds it.
QWidget* dropTargetIn(MainWindow& window) {
  QWidget* target = window.childAt(window.view().mapTo(&window, window.view().rect().center()));
  while (target && !target->acceptDrops()) target = target->parentWidget();
  return target;
}

}  // namespace

class OpeningTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void everyKindOfFileIsDropped();
  void recentFilesAreListed();
  void aWrittenExrBringsBackItsSession();
  void texelsAreCalledAsTheFileCallsThem();
  void howFarTheReadingIsCanBeSeenAndStopped();

 private:
  void drop(const std::string& file);
};

void OpeningTest::drop(const std::string& file) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file))});
  QWidget* target = dropTargetIn(*window_);
  QVERIFY(target);
  QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(target, &enter);
  QVERIFY(enter.isAccepted());
  QVERIFY(!window_->controller().loading());  // it is only dragged as yet
  QDropEvent dropped({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(target, &dropped);
  QVERIFY(dropped.isAccepted());
}

void OpeningTest::everyKindOfFileIsDropped() {
  MainWindow& window = open();
  drop(writeDepths("d.exr", rampOver(0.2F, 0.8F, 1.0F)));
  untilOpen("d.exr");
  QVERIFY(window.controller().document().content.depth);
  drop(writeFile("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  untilOpen("t.obj");
  QVERIFY(window.controller().document().content.scene);
  // A portable float map of two texels.
  const float two[] = {0.25F, 0.75F};
  drop(writeFile("p.pfm", "Pf\n2 1\n-1.0\n" + std::string(reinterpret_cast<const char*>(two), 8)));
  untilOpen("p.pfm");
  QCOMPARE(window.controller().document().content.depth->width(), 2);
  drop(writeFile("s.json", R"({"format": "umbrascope-session/1", "source": {"scene": "fence"}})"));
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().session().source.name, std::string("fence"),
                            patience);
  // What is no file is not taken.
  QMimeData text;
  text.setText("no file");
  QDragEnterEvent enter({5, 5}, Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QCoreApplication::sendEvent(&window, &enter);
  QVERIFY(!enter.isAccepted());
}

void OpeningTest::recentFilesAreListed() {
  MainWindow& window = open();
  forgetRecentFiles();
  auto* menu = window.findChild<RecentMenu*>();
  QVERIFY(menu);
  std::vector<std::string> files;
  for (int i = 0; i < 12; ++i) {
    const std::string name = "r" + std::to_string(i) + ".exr";
    files.push_back(writeDepths(name.c_str(), rampOver(0.2F, 0.8F, 1.0F)));
    window.openFile(files.back());
  }
  window.openFile(files[5]);
  window.openFile(folder_.filePath("never.exr").toStdString());  // is not there
  QCOMPARE(recentFiles().size(), std::size_t(10));
  QCOMPARE(recentFiles()[0].string(), files[5]);
  QCOMPARE(recentFiles()[1].string(), files[11]);
  QCOMPARE(recentFiles()[9].string(), files[2]);  // once 5 is first, 2 is the tenth
  settle();
  QVERIFY(QFile::remove(QString::fromStdString(files[11])));
  emit menu->aboutToShow();
  QCOMPARE(menu->actions()[0]->text(), QString("r5.exr"));
  QVERIFY(menu->actions()[0]->isEnabled());
  QCOMPARE(menu->actions()[1]->text(), QString("r11.exr"));
  QVERIFY(!menu->actions()[1]->isEnabled());
  menu->actions()[2]->trigger();
  untilOpen("r10.exr");
  // A channel that was asked for is asked for again.
  window.openFile(files[10] + ":Z");
  emit menu->aboutToShow();
  QCOMPARE(menu->actions()[0]->text(), QString("r10.exr:Z"));
  QVERIFY(menu->actions()[0]->isEnabled());
  menu->actions()[0]->trigger();
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().session().source.depth.channel, std::string("Z"),
                            patience);
}

// With a channel's name the same file is a depth map.
void OpeningTest::aWrittenExrBringsBackItsSession() {
  MainWindow& window = open();
  Workspace made;
  made.shared.source.name = "fence";
  made.shared.technique = "esm";
  made.shared.frame.kernel.radius = 5;
  const Image<float> depths = rampOver(0.2F, 0.8F, 1.0F);
  const std::string name = folder_.filePath("made.exr").toStdString();
  writeExr(name, {{"Z", depths}}, sessionAttributes(made, "test"));
  window.openFile(name);
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().session().source.name, std::string("fence"),
                            patience);
  settle();
  QCOMPARE(window.controller().session().technique, std::string("esm"));
  QCOMPARE(window.controller().session().frame.kernel.radius, 5);
  window.openFile(name + ":Z");
  untilOpen("made.exr");
  QVERIFY(window.controller().document().content.depth);
}

void OpeningTest::howFarTheReadingIsCanBeSeenAndStopped() {
  MainWindow& window = open();
  MessageBanner& banner = window.centre().banner();
  emit window.controller().loadingProgressed(0.1);  // nobody waits long enough to be told
  QVERIFY(banner.text().isEmpty());
  emit window.controller().loadingChanged(true);
  QTRY_VERIFY_WITH_TIMEOUT(banner.isProgress(), patience);
  emit window.controller().loadingProgressed(0.4);
  QCOMPARE(banner.text(), QString("Opening … 40 %"));
  QSignalSpy stopped(&banner, &MessageBanner::stopAsked);
  auto* button = banner.findChild<QToolButton*>();
  QVERIFY(button->isVisible());
  QCOMPARE(button->toolTip(), QString("Stop this"));
  button->click();
  QCOMPARE(stopped.size(), 1);
  QVERIFY(banner.isProgress());  // until the work has stopped
  emit window.controller().loadingChanged(false);
  QVERIFY(banner.text().isEmpty());
}

// A file that was cut out of a larger one keeps the larger one's count.
void OpeningTest::texelsAreCalledAsTheFileCallsThem() {
  MainWindow& window = open();
  const std::string name = folder_.filePath("crop.exr").toStdString();
  {
    const Imath::Box2i part({100, 200}, {115, 211});
    Imf::Header header(part, part);
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    const std::vector<float> values(16 * 12, 0.5F);
    Imf::OutputFile file(name.c_str(), header);
    Imf::FrameBuffer frame;
    frame.insert("Z", Imf::Slice::Make(Imf::FLOAT, values.data(), part));
    file.setFrameBuffer(frame);
    file.writePixels(12);
  }
  window.openFile(name);
  untilOpen("crop.exr");
  ShadowMapView& view = window.centre().depthView();
  emit view.texelClicked(5, 7);
  // The session counts from the map's corner.
  QCOMPARE(window.controller().session().probe->x, 5);
  QVERIFY(window.evidence().region().asText().startsWith("texel\t105, 207\n"));
  emit view.canvas()->texelHovered(5, 7);
  QVERIFY(view.findChild<ColourBar*>()->label().startsWith("texel 105, 207 "));
  emit window.evidence().map().canvas()->texelHovered(0, 0);
  QVERIFY(window.evidence().map().findChild<ColourBar*>()->label().startsWith("texel 100, 200 "));
  window.savedProbes().save();
  QTRY_VERIFY_WITH_TIMEOUT(window.savedProbes().upToDate(), patience);
  QVERIFY(window.savedProbes().text(',').contains(",105,207,"));
  const QAbstractItemModel& model = *window.savedProbesPane().view().model();
  bool said = false;
  for (int column = 0; column < model.columnCount(); ++column)
    said |= model.index(0, column).data(Qt::ToolTipRole).toString().contains("texel 105, 207");
  QVERIFY(said);
}

std::unique_ptr<QObject> makeOpeningTest() {
  return std::make_unique<OpeningTest>();
}

}  // namespace umbra

#include "OpeningTest.moc"
