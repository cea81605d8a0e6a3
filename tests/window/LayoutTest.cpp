// The places of picture and docks.
#include <qwt_legend.h>
#include <qwt_plot.h>
#include <QDockWidget>
#include <QPointer>
#include <QScreen>
#include <QTest>
#include <QToolBar>
#include <QToolTip>
#include <algorithm>
#include <vector>

#include "tests/window/WindowFixture.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/plots/PlotPane.h"

namespace umbra {

class LayoutTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void theSmallestScreenHoldsEverything();
  void plotsNameTheirCurves();
  void toolTipsAreReadable();
  void aDockFloatsAndComesBack();
};

void LayoutTest::theSmallestScreenHoldsEverything() {
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
  // No tool is behind the arrow at the tool bar's end.
  const auto* more =
      window.findChild<QToolBar*>("tools")->findChild<QToolButton*>("qt_toolbar_ext_button");
  QVERIFY(!more || !more->isVisible());
}

// A legend that has its room shows its names there, on the screen, from the first probe on.
void LayoutTest::plotsNameTheirCurves() {
  MainWindow& window = open();
  auto* plot = window.evidence().curves().findChild<QwtPlot*>();
  QVERIFY(plot->legend() && plot->legend()->isVisible());
  const QRect place(plot->legend()->mapToGlobal(QPoint(0, 0)), plot->legend()->size());
  const QImage wanted = plot->legend()->grab().toImage().convertToFormat(QImage::Format_RGB32);
  const QImage shown = window.screen()
                           ->grabWindow(0, place.x(), place.y(), place.width(), place.height())
                           .toImage()
                           .convertToFormat(QImage::Format_RGB32);
  QCOMPARE(shown.size(), wanted.size());
  int inked = 0, missing = 0;
  for (int y = 0; y < wanted.height(); ++y)
    for (int x = 0; x < wanted.width(); ++x) {
      if (qGray(wanted.pixel(x, y)) > 160) continue;
      ++inked;
      missing += qGray(shown.pixel(x, y)) > 200;
    }
  QVERIFY(inked > 100);
  QVERIFY2(missing < inked / 20, qPrintable(QString("%1 of %2").arg(missing).arg(inked)));
}

// Light on dark or dark on light, whatever style and widget they come of: of the window's own and
// of a plot's read-out.
void LayoutTest::toolTipsAreReadable() {
  MainWindow& window = open();
  for (QWidget* owner : {static_cast<QWidget*>(&window),
                         static_cast<QWidget*>(window.evidence().curves().findChild<QwtPlot*>())}) {
    QVERIFY(owner);
    QToolTip::showText(window.mapToGlobal(QPoint(200, 200)), "MMMMMMMMMM", owner);
    QPointer<QWidget> tip;  // it deletes itself once it is hidden
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (widget->inherits("QTipLabel") && widget->isVisible()) tip = widget;
    QVERIFY(tip);
    const QImage shown = tip->grab().toImage();
    int darkest = 255, lightest = 0;
    for (int y = 2; y < shown.height() - 2; ++y)
      for (int x = 2; x < shown.width() - 2; ++x) {
        darkest = std::min(darkest, qGray(shown.pixel(x, y)));
        lightest = std::max(lightest, qGray(shown.pixel(x, y)));
      }
    QVERIFY2(lightest - darkest > 150, qPrintable(QString("%1 on %2").arg(lightest).arg(darkest)));
    QToolTip::hideText();
    QTRY_VERIFY(!tip || !tip->isVisible());
  }
}

void LayoutTest::aDockFloatsAndComesBack() {
  MainWindow& window = open();
  for (QDockWidget* dock : window.docks()) {
    dock->setFloating(true);
    dock->show();
    QTest::qWait(20);
    QVERIFY(dock->isFloating() && dock->isVisible());
  }
  settle();
  window.resetLayout();
  key(Qt::Key_3);
  for (QDockWidget* dock : window.docks()) QVERIFY(!dock->isFloating());
  QVERIFY(result("esm").gpu.has_value());
}

std::unique_ptr<QObject> makeLayoutTest() {
  return std::make_unique<LayoutTest>();
}

}  // namespace umbra

#include "LayoutTest.moc"
