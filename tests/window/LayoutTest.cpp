// The places of picture and docks.
#include <QDockWidget>
#include <QTest>
#include <vector>

#include "tests/window/WindowFixture.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"

namespace umbra {

class LayoutTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void theSmallestScreenHoldsEverything();
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
