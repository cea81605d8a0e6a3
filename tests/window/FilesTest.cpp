// What the window reads, writes and remembers.
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QSlider>
#include <QTest>
#include <QTextDocument>
#include <random>

#include "datasets/lessons/LessonCatalogue.h"
#include "datasets/maps/ExrFile.h"
#include "filters/core/support/Error.h"
#include "tests/window/WindowFixture.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/window/CentrePane.h"
#include "ui/window/MessageBanner.h"
#include "ui/window/WindowMemory.h"
#include "ui/window/menus/SceneForm.h"

namespace umbra {
namespace {

QByteArray contentsOf(const QString& file) {
  QFile opened(file);
  return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

}  // namespace

class FilesTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void textsOfFilesAreShownAsTheyAre();
  void pictureAndPlotsAreWritten();
  void aBadFileLeavesTheSceneOpen();
  void droppedFacesAreReported();
  void anotherSceneOpensAndUndoBringsTheFirstBack();
  void aSceneParameterRebuildsTheScene();
  void aDepthFileIsProbedByTexel();
  void aRestartBringsSessionAndLayoutBack();
};

void FilesTest::pictureAndPlotsAreWritten() {
  MainWindow& window = open();
  const QString picture = folder_.filePath("picture.png");
  window.savePicture(picture.toStdString());
  const QImage image(picture);
  QCOMPARE(image.size(), window.view().pixels());
  QVERIFY(image.convertToFormat(QImage::Format_Indexed8).colorCount() > 16);

  for (PlotPane* pane : window.evidence().plots()) {
    const QString name = folder_.filePath(QString::fromStdString(pane->plot()->name));
    for (const char* extension : {".svg", ".pdf", ".png", ".csv"})
      pane->save((name + extension).toStdString());
    QVERIFY(contentsOf(name + ".svg").contains("<svg"));
    QVERIFY(contentsOf(name + ".pdf").startsWith("%PDF"));
    QVERIFY(!QImage(name + ".png").isNull());
    QVERIFY(contentsOf(name + ".csv").count('\n') > 2);
  }
  QVERIFY(contentsOf(folder_.filePath("curves.svg")).contains("VSM"));

  const std::filesystem::path nowhere = folder_.filePath("picture.png/in-a-file.png").toStdString();
  QVERIFY_EXCEPTION_THROWN(window.savePicture(nowhere), Error);
  QCOMPARE(QImage(picture), image);
}

void FilesTest::aBadFileLeavesTheSceneOpen() {
  MainWindow& window = open();
  const Document before = window.controller().document();
  for (const char* name : {"broken.obj", "broken.exr", "broken.json", "broken.txt"}) {
    const QString file = folder_.filePath(name);
    QFile written(file);
    QVERIFY(written.open(QIODevice::WriteOnly));
    written.write("this is none of them\n");
    written.close();
    window.centre().banner().dismiss();
    window.openFile(file.toStdString());
    QTRY_VERIFY_WITH_TIMEOUT(window.centre().banner().text().contains(name), patience);
    QVERIFY(window.controller().document().content == before.content);
    QVERIFY(window.controller().session() == before.session);
  }
  QVERIFY(!window.controller().undoStack().canUndo());
}

void FilesTest::droppedFacesAreReported() {
  MainWindow& window = open();
  const QString file = folder_.filePath("flat.obj");
  QFile written(file);
  QVERIFY(written.open(QIODevice::WriteOnly));
  written.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\n");  // one is a line
  written.close();
  window.openFile(file.toStdString());
  settle();
  QCOMPARE(window.controller().document().content.scene->title, std::string("flat.obj"));
  QVERIFY(window.centre().banner().text().contains("flat.obj: 1 face without area was left out"));
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(window.centre().banner().text().isEmpty());
}

void FilesTest::anotherSceneOpensAndUndoBringsTheFirstBack() {
  MainWindow& window = open();
  const Document before = window.controller().document();
  SceneSource source;
  source.name = "three-planes";
  window.controller().openSource(source);
  QVERIFY(window.controller().loading());
  QVERIFY(window.controller().document().content == before.content);
  settle();
  QCOMPARE(window.controller().document().content.scene->name, std::string("three-planes"));
  QVERIFY(window.prober().report().has_value());
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(window.controller().document().content == before.content);
  QVERIFY(window.view().upToDate());
}

void FilesTest::aSceneParameterRebuildsTheScene() {
  Session session;
  session.source.name = "three-planes";
  MainWindow& window = open(session);
  const Document before = window.controller().document();
  auto* form = window.findChild<SceneForm*>();
  QVERIFY(form && form->adjustable());
  auto* slider = form->findChild<QSlider*>();
  const std::string name = slider->objectName().toStdString();
  slider->setValue(slider->value() > 100 ? 60 : 140);
  settle();
  const Document& after = window.controller().document();
  QVERIFY(after.session.source.parameters.contains(name));
  QVERIFY(after.content.scene != before.content.scene);
  QVERIFY(after.session.probe == before.session.probe);
  QVERIFY(window.prober().report().has_value());
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(window.controller().document().content == before.content);
}

void FilesTest::aDepthFileIsProbedByTexel() {
  MainWindow& window = open();
  Image<float> depths(48, 32);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(0.0F, 1.0F);
  for (float& depth : depths.values()) depth = any(random);
  const QString file = folder_.filePath("depths.exr");
  writeExr(file.toStdString(), {{"Z", depths}}, {});
  window.openFile(file.toStdString());
  QTRY_VERIFY_WITH_TIMEOUT(window.controller().document().content.depth != nullptr, patience);
  QVERIFY(window.centre().depthView().isVisible());
  emit window.centre().depthView().texelClicked(5, 20);
  window.controller().edit("receiver", [](Session& session) { session.receiver = 0.4; });
  const auto& report = window.prober().report();
  QVERIFY(report.has_value());
  // Counted by hand: the default kernel is a box of seven by seven.
  int behind = 0;
  for (int y = 17; y <= 23; ++y)
    for (int x = 2; x <= 8; ++x) behind += double(depths(x, y)) >= 0.4;
  QVERIFY(std::abs(report->probe.reference - behind / 49.0) < 1e-12);
  QCOMPARE(report->probe.receiver, 0.4);
  // As `umbrascope probe` reads it where no format is asked for.
  QVERIFY(report->request->format == StorageFormat::Double);
}

void FilesTest::aRestartBringsSessionAndLayoutBack() {
  Session session;
  session.source.name = "three-planes";
  MainWindow& first = open(session);
  const std::optional<Eigen::Vector3d> point = first.prober().report()->point;
  first.controller().edit("several", [](Session& s) {
    s.technique = "esm";
    s.frame.kernel = {KernelShape::Gaussian, 5, 0.0};
    s.parameters["esm"]["exponent"] = 40.0;
  });
  first.resize(1400, 850);
  first.docks()[1]->hide();
  settle();
  rememberWindow(first);
  const Workspace saved = first.sessionToSave();
  const QSize size = first.size();
  window_.reset();

  const auto last = lastSession();
  QVERIFY(last.has_value());
  QVERIFY(*last == saved);
  window_ = std::make_unique<MainWindow>(*last);
  restoreWindow(*window_);
  window_->show();
  settle();
  QCOMPARE(window_->size(), size);  // its place is the window manager's
  QVERIFY(window_->docks()[1]->isHidden());
  QVERIFY(window_->docks()[0]->isVisible());
  QCOMPARE(window_->controller().session().technique, std::string("esm"));
  // The same point of the scene is probed.
  const auto& report = window_->prober().report();
  QVERIFY(report && report->pinned && point);
  QVERIFY((*report->point - *point).norm() < 0.05 * (1.0 + point->norm()));
}

// What comes of a file, its name included, is no markup of the window: no label and no tool tip
// takes it for such.
void FilesTest::textsOfFilesAreShownAsTheyAre() {
  MainWindow& window = open();
  const QString markup = "<b>bold</b><img src='x.png'>";
  const auto check = [&](const char* what) {
    int shown = 0;
    for (const QLabel* label : window.findChildren<QLabel*>()) {
      if (!label->text().contains("<b>bold")) continue;
      ++shown;
      QVERIFY2(label->textFormat() == Qt::PlainText, what);
    }
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
      if (!widget->toolTip().contains("bold")) continue;
      QTextDocument tip;
      if (Qt::mightBeRichText(widget->toolTip()))
        tip.setHtml(widget->toolTip());
      else
        tip.setPlainText(widget->toolTip());
      QVERIFY2(tip.toPlainText().contains("<b>bold"), what);
    }
    QVERIFY2(shown > 0, what);
  };
  const QString file = folder_.filePath("s.json");
  QFile written(file);
  QVERIFY(written.open(QIODevice::WriteOnly));
  written.write(("{\"format\": \"umbrascope-session/1\", \"frame\": \"" + markup + "\"}").toUtf8());
  written.close();
  window.openFile(file.toStdString());
  settle();
  check("a message");
  Lesson lesson = lessonNamed("layers");
  lesson.title = lesson.after = lesson.summary = lesson.steps[0].title = markup.toStdString();
  window.enterLesson(lesson);
  settle();
  check("a lesson");
}

std::unique_ptr<QObject> makeFilesTest() {
  return std::make_unique<FilesTest>();
}

}  // namespace umbra

#include "FilesTest.moc"
