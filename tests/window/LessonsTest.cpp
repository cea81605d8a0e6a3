// Lessons: what they veil and show, and that one's own session outlives them.
#include <QAbstractItemModel>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTest>

#include "datasets/lessons/LessonCatalogue.h"
#include "tests/window/WindowFixture.h"
#include "ui/lessons/LessonController.h"
#include "ui/lessons/LessonPane.h"
#include "ui/lessons/LessonQuestionPane.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/window/WindowMemory.h"

namespace umbra {
namespace {

int rowsOf(MainWindow& window) {
  return window.evidence().table().view()->model()->rowCount();
}

// Lauritzen 2008, eq. 3.4.
double bleedingOf(double dx, double dy) {
  return 0.25 * dx * dx / (0.5 * dx * dx + dx * dy + dy * dy);
}

}  // namespace

class LessonsTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void lightBleedingIsPredictedThenMeasured();
  void aLessonIsWalkedByKeyAndKeepsItsPredictions();
  void stepsMeasureTheSameInEveryWindow();
  void everyStepCanBeSeenOnASmallScreen();
  void aLessonLeavesOnesOwnSessionAsItWas();
  void quittingInALessonRemembersOnesOwnSession();
};

void LessonsTest::lightBleedingIsPredictedThenMeasured() {
  MainWindow& window = open();
  auto* menu = window.findChild<QMenu*>("lessonsMenu");
  for (QAction* action : menu->actions())
    if (action->data().toString() == "light-bleeding") action->trigger();
  settle();
  auto* dock = window.findChild<QDockWidget*>("lessonDock");
  QVERIFY(dock->isVisible());
  QCOMPARE(window.lessonPane().title(), QString("Light bleeding"));
  QVERIFY(result("vsm").visibility > 0.2);  // nothing is asked yet, so nothing is hidden

  auto* next = window.findChild<QPushButton*>("lessonNext");
  for (int i = 0; i < 2; ++i) {
    next->click();
    settle();
  }
  QVERIFY(window.lessons().progress()->veiled());
  QVERIFY(!window.prober().report());
  for (PlotPane* plot : window.evidence().plots()) QVERIFY(!plot->plot());
  QCOMPARE(rowsOf(window), 0);
  LessonQuestionPane& question = window.lessonPane().question();
  QVERIFY(question.isVisible());
  QVERIFY(question.measuredText().isEmpty());

  // Nothing is predicted for the reader.
  QVERIFY(!window.findChild<QPushButton*>("predictionButton")->isEnabled());
  QTest::keyClick(question.field(), Qt::Key_Return);
  QVERIFY(window.lessons().progress()->veiled());

  // The lower end is a prediction like any other.
  question.slider()->setFocus();
  QTest::keyClick(question.slider(), Qt::Key_Left);
  QCOMPARE(question.field()->value(), 0.0);
  QVERIFY(window.findChild<QPushButton*>("predictionButton")->isEnabled());
  question.field()->setFocus();

  // The prediction is made by the slider, then set to the figure in the field, with Enter.
  question.slider()->setValue(question.slider()->maximum() / 4);
  QCOMPARE(question.field()->value(), 0.25);
  const double predicted = bleedingOf(0.44, 0.20);
  question.field()->setValue(predicted);
  QVERIFY(question.field()->hasFocus());  // what is typed chooses no technique
  QTest::keyClick(question.field(), Qt::Key_Return);
  settle();
  QVERIFY(!window.lessons().progress()->veiled());
  QVERIFY(rowsOf(window) > 5);
  QVERIFY(window.evidence().curves().plot().has_value());
  const double measured = result("vsm").visibility;
  QCOMPARE(question.measuredText(), QString::number(measured, 'f', 3));
  QVERIFY(std::abs(measured - predicted) <=
          window.lessons().progress()->current().question->tolerance);
  QVERIFY(question.verdict().startsWith("Right: you said"));
  QCOMPARE(window.prober().report()->probe.reference, 0.0);
}

void LessonsTest::aLessonIsWalkedByKeyAndKeepsItsPredictions() {
  MainWindow& window = open();
  window.enterLesson(lessonNamed("vsm-planes"));
  settle();
  const auto step = [&] { return window.lessons().progress()->step; };
  key(Qt::Key_Left, Qt::AltModifier);
  QCOMPARE(step(), std::size_t(0));
  key(Qt::Key_Right, Qt::AltModifier);
  QCOMPARE(step(), std::size_t(1));
  window.lessons().predict(0.07);
  QVERIFY(window.lessonPane().question().verdict().startsWith("You said 0.070"));
  key(Qt::Key_Right, Qt::AltModifier);
  QVERIFY(window.lessons().progress()->veiled());
  key(Qt::Key_Left, Qt::AltModifier);
  QVERIFY(!window.lessons().progress()->veiled());
  QCOMPARE(*window.lessons().progress()->prediction(), 0.07);
  QVERIFY(window.lessonPane().question().verdict().startsWith("You said 0.070"));
  // What is changed in a step is put back with it.
  window.controller().edit("kernel", [](Session& s) { s.frame.kernel.radius = 1; });
  window.lessons().restart();
  settle();
  QCOMPARE(window.controller().session().frame.kernel.radius, 7);
  while (!window.lessons().progress()->atLast()) key(Qt::Key_Right, Qt::AltModifier);
  window.findChild<QPushButton*>("lessonNext")->click();  // now "Finish"
  settle();
  QVERIFY(!window.lessons().progress());
  QVERIFY(!window.findChild<QDockWidget*>("lessonDock")->isVisible());
}

// What a lesson tells is true on whatever screen it is read.
void LessonsTest::stepsMeasureTheSameInEveryWindow() {
  MainWindow& window = open();
  std::map<std::string, double> first;
  for (const QSize size : {QSize(1280, 720), QSize(1000, 900), QSize(1600, 900)}) {
    window.resize(size);
    settle();
    for (const char* name : {"vsm-planes", "half-floats"}) {
      window.enterLesson(lessonNamed(name));
      while (true) {
        const LessonProgress& progress = *window.lessons().progress();
        settle();
        if (progress.veiled()) {
          window.lessons().predict(progress.current().question->low);
          settle();
          const std::string key = std::string(name) + std::to_string(progress.step);
          const double tolerance = progress.current().question->tolerance;
          QVERIFY(window.lessons().measurement().has_value());
          const double measured = *window.lessons().measurement();
          const double before = first.emplace(key, measured).first->second;
          QVERIFY2(std::abs(measured - before) <= tolerance / 2.0, key.c_str());
        }
        if (progress.atLast()) break;
        window.lessons().next();
      }
      window.lessons().leave();
    }
  }
  QVERIFY(first.size() >= 3);
}

// On the smallest screen the point of every step is in sight, its text is not cut, and one can go
// on. The pictures of all steps lie in lessons.png, beside this program's output.
void LessonsTest::everyStepCanBeSeenOnASmallScreen() {
  MainWindow& window = open();
  window.resize(1280, 720);
  window.resetLayout();
  settle();
  const QSize cell(640, 360);
  std::vector<QPixmap> pictures;
  for (const Lesson& lesson : lessonCatalogue()) {
    window.enterLesson(lesson);
    while (true) {
      settle();
      const LessonProgress& progress = *window.lessons().progress();
      const QString place =
          QString::fromStdString(lesson.name) + " " + QString::number(progress.step + 1);
      const auto& report = window.prober().behindVeil();
      QVERIFY2(report && report->pinned && report->inSight, qPrintable(place));
      QVERIFY2(
          window.findChild<QPushButton*>("lessonNext")->visibleRegion().boundingRect().height() >
              15,
          qPrintable(place));
      const auto* page = window.findChild<QWidget*>("lessonPage");
      for (const QLabel* label : page->findChildren<QLabel*>())
        if (label->isVisible())
          QVERIFY2(label->mapTo(page, label->rect().topRight()).x() < page->parentWidget()->width(),
                   qPrintable(place + ": " + label->text()));
      pictures.push_back(window.grab().scaled(cell, Qt::KeepAspectRatio, Qt::SmoothTransformation));
      if (progress.atLast()) break;
      window.lessons().next();
    }
    window.lessons().leave();
    settle();
  }
  const int columns = 6, rows = (int(pictures.size()) + columns - 1) / columns;
  QPixmap sheet(columns * cell.width(), rows * cell.height());
  sheet.fill(Qt::white);
  QPainter painter(&sheet);
  for (int i = 0; i < int(pictures.size()); ++i)
    painter.drawPixmap(i % columns * cell.width(), i / columns * cell.height(),
                       pictures[std::size_t(i)]);
  painter.end();
  QVERIFY(sheet.save("lessons.png"));
}

void LessonsTest::aLessonLeavesOnesOwnSessionAsItWas() {
  MainWindow& window = open();
  window.controller().edit("radius", [](Session& s) { s.frame.kernel.radius = 5; });
  window.controller().edit("technique", [](Session& s) { s.technique = "msm"; });
  settle();
  key(Qt::Key_Z, Qt::ControlModifier);  // and one step that can be redone
  const Workspace own = window.sessionToSave();
  const Content content = window.controller().document().content;
  const Eigen::Vector3d point = *window.prober().report()->point;

  window.enterLesson(lessonNamed("light-bleeding"));
  settle();
  QVERIFY(window.controller().visiting());
  QVERIFY(!window.controller().undoStack().canUndo());
  window.controller().edit("map", [](Session& s) { s.frame.map.size = 512; });
  settle();
  key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.controller().session().frame.map.size, 1024);
  window.lessons().next();
  settle();
  QVERIFY(window.sessionToRemember() == own);

  window.leaveLesson();
  settle();
  QVERIFY(!window.controller().visiting());
  QVERIFY(window.controller().workspace() == own);
  QVERIFY(window.controller().document().content == content);
  // The probe is on its point again, to the pixel's size there: the picture may have another width.
  const Camera& camera = content.scene->camera;
  const double away = (camera.position - point).norm();
  const double pixelSize = 2.0 * away *
                           std::tan(camera.viewAngle * 0.5 * 3.14159265358979 / 180.0) /
                           window.view().pixels().height();
  QVERIFY((*window.prober().report()->point - point).norm() < 4.0 * pixelSize);
  QCOMPARE(window.controller().undoStack().count(), 2);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(window.controller().session().technique, std::string("msm"));
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.controller().session().frame.kernel.radius, 3);
}

void LessonsTest::quittingInALessonRemembersOnesOwnSession() {
  MainWindow& window = open();
  window.controller().edit("radius", [](Session& s) { s.frame.kernel.radius = 6; });
  settle();
  const Workspace own = window.sessionToSave();
  window.enterLesson(lessonNamed("layers"));
  settle();
  QObject::connect(&window, &MainWindow::closing, &window, [&] { rememberWindow(window); });
  window.close();
  const auto last = lastSession();
  QVERIFY(last.has_value());
  QVERIFY(*last == own);

  window_ = std::make_unique<MainWindow>(*last);
  restoreWindow(*window_);
  window_->show();
  settle();
  QVERIFY(!window_->findChild<QDockWidget*>("lessonDock")->isVisible());
  QVERIFY(window_->docks().front()->isVisible());
}

std::unique_ptr<QObject> makeLessonsTest() {
  return std::make_unique<LessonsTest>();
}

}  // namespace umbra

#include "LessonsTest.moc"
