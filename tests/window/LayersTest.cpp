// The pane of the layers: splits by hand and by Lloyd's relaxation.
#include <qwt_plot.h>

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <cmath>

#include "filters/core/technique/Lloyd.h"
#include "filters/techniques/lvsm/Layers.h"
#include "tests/widgets/Mouse.h"
#include "tests/window/WindowFixture.h"
#include "ui/layers/LayersPane.h"
#include "ui/picture/SceneView.h"
#include "ui/widgets/plots/PlotPane.h"

namespace umbra {
namespace {

Session layeredSession() {
  Session session;
  session.technique = "lvsm";
  return session;
}

// Raises the pane and waits until its plots are there.
LayersPane& layersPaneOf(MainWindow& window) {
  window.findChild<QDockWidget*>("layersDock")->raise();
  auto* pane = window.findChild<LayersPane*>();
  if (!QTest::qWaitFor([&] { return pane->cost().plot().has_value(); }, patience))
    qFatal("no second occluders were found");
  return *pane;
}

// The splits of the session; none while they are not manual.
std::vector<double> manualSplits(MainWindow& window) {
  const auto& all = window.controller().session().parameters;
  const auto technique = all.find("lvsm");
  if (technique == all.end() || !technique->second.contains("splits")) return {};
  return std::get<std::vector<double>>(technique->second.at("splits"));
}

std::vector<double> shownSplits(LayersPane& pane) {
  std::vector<double> splits;
  for (const PlotMarker& marker : pane.histogram().plot()->markers)
    splits.push_back(marker.position);
  return splits;
}

std::vector<double> relaxed(MainWindow& window, int iterations) {
  const DepthMap& map = window.view().lastFrame()->depthMap();
  const LloydOptions options{.splits = 3, .maxIterations = iterations};
  return keptApart(relax(secondOccluderSamples(map), options).splits);
}

void press(MainWindow& window, const char* button) {
  window.findChild<QPushButton*>(button)->click();
}

const std::vector<double> uniform{0.25, 0.5, 0.75};

}  // namespace

class LayersTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void aSplitIsDragged();
  void lloydIsSteppedToItsEndAndUndone();
  void whatLloydPlayedIsOneStep();
  void aTechniqueWithoutLayersNamesThoseThatHaveThem();
};

void LayersTest::aSplitIsDragged() {
  MainWindow& window = open(layeredSession());
  LayersPane& pane = layersPaneOf(window);
  QCOMPARE(shownSplits(pane), uniform);
  QwtPlot& plot = *pane.histogram().canvas();
  QWidget* canvas = plot.canvas();
  const auto at = [&](double depth) {
    return QPoint(int(std::lround(plot.transform(QwtPlot::xBottom, depth))), canvas->height() / 2);
  };
  const double pixel =
      plot.invTransform(QwtPlot::xBottom, 1) - plot.invTransform(QwtPlot::xBottom, 0);
  QTest::mousePress(canvas, Qt::LeftButton, {}, at(0.5));
  moveMouse(canvas, at(0.55), Qt::LeftButton);
  moveMouse(canvas, at(0.6), Qt::LeftButton);
  std::vector<double> splits = manualSplits(window);  // before the button is let go
  QCOMPARE(splits.size(), std::size_t(3));
  QVERIFY(std::abs(splits[1] - 0.6) <= pixel);
  QCOMPARE(shownSplits(pane), splits);
  // A split that is dragged past its neighbour stops before it.
  moveMouse(canvas, at(0.9), Qt::LeftButton);
  splits = manualSplits(window);
  QVERIFY(splits[1] < 0.75 && splits[1] > 0.7);
  QCOMPARE(splits[0], 0.25);
  QCOMPARE(splits[2], 0.75);
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, at(0.9));
  settle();
  const auto& parameters = window.controller().session().parameters.at("lvsm");
  QCOMPARE(std::get<std::string>(parameters.at("placement")), std::string("manual"));
  QCOMPARE(window.controller().undoStack().count(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(manualSplits(window).empty());
  QCOMPARE(shownSplits(pane), uniform);
}

void LayersTest::lloydIsSteppedToItsEndAndUndone() {
  MainWindow& window = open(layeredSession());
  LayersPane& pane = layersPaneOf(window);
  const auto costs = [&] { return pane.cost().plot()->series[0].y; };
  QCOMPARE(costs().size(), std::size_t(1));
  QCOMPARE(costs()[0], pane.cost().plot()->markers[0].position);  // uniform's

  press(window, "lloydStep");
  settle();
  const std::vector<double> once = manualSplits(window);
  QCOMPARE(once, relaxed(window, 1));
  QCOMPARE(shownSplits(pane), once);
  QCOMPARE(costs().size(), std::size_t(2));
  QVERIFY(costs()[1] < costs()[0]);

  press(window, "lloydEnd");
  settle();
  QCOMPARE(manualSplits(window), relaxed(window, LloydOptions().maxIterations));
  for (std::size_t i = 1; i < costs().size(); ++i) QVERIFY(costs()[i] <= costs()[i - 1]);
  auto* step = window.findChild<QPushButton*>("lloydStep");
  QVERIFY(!step->isEnabled());
  const std::size_t iterations = costs().size();

  // Undo goes back among the iterations, which stay in sight.
  key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(manualSplits(window), once);
  QCOMPARE(costs().size(), iterations);
  QCOMPARE(pane.cost().plot()->series[1].x[0], 1.0);
  QVERIFY(step->isEnabled());
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(manualSplits(window).empty());
  QCOMPARE(shownSplits(pane), uniform);
}

void LayersTest::whatLloydPlayedIsOneStep() {
  MainWindow& window = open(layeredSession());
  LayersPane& pane = layersPaneOf(window);
  press(window, "lloydPlay");
  QVERIFY(QTest::qWaitFor([&] { return pane.cost().plot()->series[0].y.size() >= 3; }, patience));
  press(window, "lloydPlay");
  settle();
  QCOMPARE(window.controller().undoStack().count(), 1);
  const std::vector<double> played = manualSplits(window);
  QCOMPARE(played, relaxed(window, int(pane.cost().plot()->series[0].y.size()) - 1));
  press(window, "lloydStart");
  settle();
  QVERIFY(manualSplits(window).empty());
  QCOMPARE(pane.cost().plot()->series[0].y.size(), std::size_t(1));
  key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(manualSplits(window), played);
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(manualSplits(window).empty());
}

void LayersTest::aTechniqueWithoutLayersNamesThoseThatHaveThem() {
  MainWindow& window = open();
  window.findChild<QDockWidget*>("layersDock")->raise();
  settle();
  auto* pane = window.findChild<LayersPane*>();
  QVERIFY(!pane->histogram().plot());
  bool named = false;
  for (const QLabel* label : pane->histogram().findChildren<QLabel*>())
    named = named || (label->text().contains("LVSM") && label->text().contains("ower CDF"));
  QVERIFY(named);
  QVERIFY(!window.findChild<QPushButton*>("lloydStep")->isEnabled());
  window.controller().edit("Choose",
                           [](Session& session) { session.technique = "layered-power-cdf"; });
  settle();
  QVERIFY(QTest::qWaitFor([&] { return pane->cost().plot().has_value(); }, patience));
  QCOMPARE(shownSplits(*pane), uniform);
}

std::unique_ptr<QObject> makeLayersTest() {
  return std::make_unique<LayersTest>();
}

}  // namespace umbra

#include "LayersTest.moc"
