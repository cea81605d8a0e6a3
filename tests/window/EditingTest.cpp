// Changes: parameters, techniques, view, light, receiver, and their undoing.
#include <QAbstractItemModel>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTest>

#include "tests/window/WindowFixture.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/Prober.h"
#include "ui/probe/ReductionTools.h"
#include "ui/widgets/forms/ParameterForm.h"
#include "ui/widgets/forms/TechniqueList.h"
#include "ui/widgets/maps/ColourBar.h"
#include "ui/widgets/maps/ShadowMapCanvas.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/window/ControlPane.h"

namespace umbra {
namespace {

QSlider* sliderOf(MainWindow& window, const char* parameter) {
  return window.controls().parameters().findChild<QWidget*>(parameter)->findChild<QSlider*>();
}

}  // namespace

class EditingTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void aParameterChangeIsUndoneAndRedone();
  void theSmallestReductionOfTheRegionIsSetAndPriced();
  void theSmallestReductionOfThePictureDarkensEveryUmbra();
  void whatAFormatCannotHoldCannotBeChosen();
  void anotherNumberOfLayersDropsTheSplits();
  void aSliderDragIsOneStep();
  void digitsSwitchTechniques();
  void keysSwitchTheView();
  void draggingTheSunMovesTheLight();
  void lightAndCameraAreSetInNumbers();
  void draggingTheReceiverIsStudiedUntilReset();
  void aMapChannelCanBeLookedAt();
  void aProbeIsOnTheMapOfItsCascade();
  void whatATableOfSumsCannotServeCannotBeChosen();
};

void EditingTest::aParameterChangeIsUndoneAndRedone() {
  MainWindow& window = open();
  const double before = result("vsm").visibility;
  QSlider* slider = sliderOf(window, "bleed-reduction");
  slider->setValue(slider->maximum() / 4);
  settle();
  const auto& parameters = window.controller().session().parameters;
  const double a = std::get<double>(parameters.at("vsm").at("bleed-reduction"));
  QVERIFY(a > 0.0 && a < 1.0);
  // Lauritzen 2008, §3.4.
  const double expected = std::clamp((before - a) / (1.0 - a), 0.0, 1.0);
  QVERIFY(std::abs(result("vsm").visibility - expected) < 1e-12);
  // The frame was drawn again with the parameter: in 32 bits, as the table's GPU column shows.
  QVERIFY(result("vsm").gpu.has_value());

  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!window.controller().session().parameters.contains("vsm"));
  QCOMPARE(result("vsm").visibility, before);
  QCOMPARE(slider->value(), slider->minimum());
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(std::abs(result("vsm").visibility - expected) < 1e-12);
}

void EditingTest::theSmallestReductionOfTheRegionIsSetAndPriced() {
  MainWindow& window = open();
  const double reference = window.prober().report()->probe.reference;
  const double before = result("vsm").visibility;
  QVERIFY(before > reference + 0.05);
  ReductionTools& tools = window.controls().reduction();
  window.findChild<QPushButton*>("reduceRegion")->click();
  settle();
  const auto& parameters = window.controller().session().parameters;
  const double a = std::get<double>(parameters.at("vsm").at("bleed-reduction"));
  // (p − a)/(1 − a) = r, rounded up to the four decimals that the form shows.
  const double exact = (before - reference) / (1.0 - reference);
  QVERIFY(a >= exact - 1e-9 && a < exact + 1.1e-4);
  QVERIFY(result("vsm").error <= 1e-9);
  QVERIFY(tools.said().contains("removes all bleeding here"));
  QCOMPARE(window.controller().undoStack().count(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(result("vsm").visibility, before);
  QVERIFY(tools.said().isEmpty());
}

void EditingTest::theSmallestReductionOfThePictureDarkensEveryUmbra() {
  Session session;
  session.source.name = "three-planes";
  MainWindow& window = open(session);
  // The bound is measured without the reduction, whatever is set now.
  window.controller().edit("half",
                           [](Session& s) { s.parameters["vsm"]["bleed-reduction"] = 0.5; });
  settle();
  window.findChild<QPushButton*>("reduceFrame")->click();
  settle();
  const auto& parameters = window.controller().session().parameters;
  const double a = std::get<double>(parameters.at("vsm").at("bleed-reduction"));
  QVERIFY(a > 0.05 && a < 0.99 && a != 0.5);
  const auto brightestUmbra = [&] {
    const SurfaceImage surfaces = window.view().lastFrame()->surfaces();
    const Image<float> truth = window.view().lastFrame()->reference();
    double brightest = 0.0;
    for (const BoundSample& sample : boundSamplesOf(surfaces, truth))
      if (sample.reference == 0.0) brightest = std::max(brightest, sample.bound);
    return brightest;
  };
  QVERIFY(brightestUmbra() < 1e-5);
  QVERIFY(window.controls().reduction().said().contains("full shadow"));
  window.controller().edit("less",
                           [a](Session& s) { s.parameters["vsm"]["bleed-reduction"] = a - 0.01; });
  settle();
  QVERIFY(brightestUmbra() > 1e-3);
}

void EditingTest::whatAFormatCannotHoldCannotBeChosen() {
  MainWindow& window = open();
  window.controller().edit("format",
                           [](Session& s) { s.frame.map.format = StorageFormat::Unorm16; });
  settle();
  QVERIFY(window.prober().report().has_value());
  QCOMPARE(result("vsm").technique->info().id, std::string_view("vsm"));
  key(Qt::Key_3);  // ESM
  QCOMPARE(window.controller().session().technique, std::string("vsm"));
  key(Qt::Key_M);
  QCOMPARE(window.controller().session().technique, std::string("msm"));
  bool dash = false;
  const QAbstractItemModel& table = *window.evidence().table().view()->model();
  const int techniques = int(window.controller().techniques().size());
  QCOMPARE(table.rowCount(), techniques + 1);  // and the rays
  for (int row = 0; row < techniques; ++row)
    dash = dash || (table.index(row, 1).data().toString() == QString::fromUtf8("–") &&
                    table.index(row, 0).data(Qt::ToolTipRole).toString().startsWith("esm stores"));
  QVERIFY(dash);
}

void EditingTest::anotherNumberOfLayersDropsTheSplits() {
  MainWindow& window = open();
  window.controller().edit("Choose", [](Session& session) { session.technique = "lvsm"; });
  const auto change = [&](const char* name, const ParameterValue& value) {
    emit window.controls().parameters().parameterChanged(name, value);
    settle();
  };
  const auto channels = [&] { return window.controller().technique().channels().size(); };
  change("splits", std::vector<double>{0.2, 0.5});
  QCOMPARE(channels(), std::size_t(2 * 3));  // two moments a layer
  change("layers", 7);
  QCOMPARE(channels(), std::size_t(2 * 7));
  change("splits", std::vector<double>{0.2, 0.5});
  QCOMPARE(channels(), std::size_t(2 * 3));
  change("placement", std::string("lloyd"));
  QVERIFY(window.controller().technique().clone()->adaptedSplitCount() > 0);
}

void EditingTest::aSliderDragIsOneStep() {
  MainWindow& window = open();
  QUndoStack& undo = window.controller().undoStack();
  QSlider* slider = sliderOf(window, "bleed-reduction");
  for (int i = 1; i <= 5; ++i) slider->setValue(slider->maximum() * i / 10);
  QCOMPARE(undo.count(), 1);
  emit window.controls().parameters().editingFinished("bleed-reduction");
  slider->setValue(slider->maximum() / 10);
  QCOMPARE(undo.count(), 2);
  settle();
}

void EditingTest::digitsSwitchTechniques() {
  MainWindow& window = open();
  const auto all = window.controller().catalogue().all();
  for (int digit : {0, 3, 1}) {
    key(Qt::Key_0 + digit);
    const std::string id(all[std::size_t(digit)]->info().id);
    QCOMPARE(window.controller().session().technique, id);
    QCOMPARE(window.controls().techniques().current().toStdString(), id);
    // The frame has used it.
    QVERIFY(result(id.c_str()).gpu.has_value());
  }
}

void EditingTest::keysSwitchTheView() {
  MainWindow& window = open();
  const auto picture = [&] { return window.view().grabFramebuffer(); };
  const QImage shaded = picture();
  std::vector<QImage> seen{shaded};
  const std::pair<int, ViewMode> modes[] = {{Qt::Key_F3, ViewMode::Visibility},
                                            {Qt::Key_F4, ViewMode::Error},
                                            {Qt::Key_F5, ViewMode::Depth}};
  for (const auto& [shortcut, mode] : modes) {
    key(shortcut);
    QVERIFY(window.controller().session().frame.view == mode);
    const QImage image = picture();
    for (const QImage& other : seen) QVERIFY(image != other);
    seen.push_back(image);
  }
  // A view with nothing to show says so.
  auto* legend = window.findChild<ColourBar*>("legend");
  key(Qt::Key_F6);
  QVERIFY(legend->isVisible() && legend->toolTip().contains("has no layers"));
  key(Qt::Key_6);
  QVERIFY(!legend->isVisible());
  key(Qt::Key_F7);
  QVERIFY(legend->isVisible() && legend->toolTip().contains("one cascade"));
  key(Qt::Key_2);
  key(Qt::Key_F2);
  QCOMPARE(picture(), shaded);
}

void EditingTest::draggingTheSunMovesTheLight() {
  MainWindow& window = open();
  const Light before = window.controller().document().content.scene->light;
  const auto sun = window.view().lightHandle().position();
  QVERIFY(sun.has_value());
  mouse(QEvent::MouseButtonPress, *sun, Qt::LeftButton, Qt::LeftButton);
  for (int i = 1; i <= 3; ++i)
    mouse(QEvent::MouseMove, *sun + QPointF(-15.0 * i, 4.0 * i), Qt::NoButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, *sun + QPointF(-45.0, 12.0), Qt::LeftButton, Qt::NoButton);
  settle();
  QVERIFY(window.controller().session().light.has_value());
  const Light after = *window.controller().session().light;
  QVERIFY((after.position - before.position).norm() > 0.01 * before.position.norm());
  if (before.kind == LightKind::Directional) {
    const double distance = (before.position - before.target).norm();
    QVERIFY(std::abs((after.position - after.target).norm() - distance) < 1e-9 * distance);
  }
  QCOMPARE(window.controller().undoStack().count(), 1);
  QVERIFY(!window.controller().session().camera);  // the camera stood still
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!window.controller().session().light);
}

void EditingTest::lightAndCameraAreSetInNumbers() {
  MainWindow& window = open();
  const auto boxesOf = [&](const char* setting) {
    return window.findChild<QWidget*>(setting)->findChildren<QDoubleSpinBox*>();
  };
  const Scene& scene = *window.controller().document().content.scene;
  QCOMPARE(boxesOf("light.position").size(), 3);
  QCOMPARE(boxesOf("light.position")[1]->value(), scene.light.position.y());
  boxesOf("light.position")[1]->setValue(scene.light.position.y() + 2.0);
  boxesOf("light.position")[1]->setValue(scene.light.position.y() + 3.0);
  settle();
  QCOMPARE(window.controller().session().light->position.y(), scene.light.position.y() + 3.0);
  QCOMPARE(window.controller().undoStack().count(), 1);
  boxesOf("camera.view-angle")[0]->setValue(50.0);
  settle();
  QCOMPARE(window.controller().session().camera->viewAngle, 50.0);
  QCOMPARE(window.view().camera().viewAngle, 50.0);
  // A camera in its own target gives no picture: it is refused, and the box shows what is.
  const Eigen::Vector3d target = scene.camera.target;
  window.controller().edit(
      "On the axis", [&](Session& s) { s.camera->position = target + Eigen::Vector3d::UnitX(); });
  settle();
  boxesOf("camera.position")[0]->setValue(target.x());
  QCOMPARE(window.controller().session().camera->position.x(), target.x() + 1.0);
  QCOMPARE(boxesOf("camera.position")[0]->value(), target.x() + 1.0);
}

void EditingTest::draggingTheReceiverIsStudiedUntilReset() {
  MainWindow& window = open();
  const double own = window.prober().report()->probe.receiver;
  emit window.evidence().curves().depthDragged(0.9);
  emit window.evidence().curves().depthDragged(0.95);
  emit window.evidence().curves().depthDragFinished();
  settle();
  QCOMPARE(window.prober().report()->probe.receiver, 0.95);
  QVERIFY(window.prober().report()->receiverByHand);
  QVERIFY(!result("vsm").gpu);  // the frame knows nothing of that depth
  QCOMPARE(window.controller().undoStack().count(), 1);
  key(Qt::Key_R);
  QCOMPARE(window.prober().report()->probe.receiver, own);
}

void EditingTest::aMapChannelCanBeLookedAt() {
  MainWindow& window = open();
  ShadowMapView& map = window.evidence().map();
  const Region& region = window.prober().report()->probe.region;
  const QPoint texel(region.x, region.y);
  QCOMPARE(double(map.canvas()->valueAt(texel)), region.nearestDepth);
  auto* channels = map.findChild<QComboBox*>();
  channels->setFocus();
  QTest::keyClick(channels, Qt::Key_Down);
  QCOMPARE(map.currentChannel(), QString("M1 filtered"));
  const Image<float> filtered = window.view().lastFrame()->channels(BakeStage::Prefiltered);
  QCOMPARE(map.canvas()->valueAt(texel), filtered(texel.x(), texel.y(), 0));
}

void EditingTest::aProbeIsOnTheMapOfItsCascade() {
  Session session;
  session.source.name = "three-planes";
  session.frame.read.filter = ReadFilter::Anisotropic;
  session.frame.map.cascades.count = 3;
  MainWindow& window = open(session);
  const Pixel pixel = window.prober().report()->pixel;
  const auto surface = window.view().surfaceAt(pixel);
  QVERIFY(surface.has_value());
  const ProbeReport& report = *window.prober().report();
  QCOMPARE(report.cascade, surface->cascade);
  const FrameSettings& frame = window.controller().session().frame;
  ShadowRenderer& drawn = *window.view().lastFrame();
  const DepthMap& map = drawn.depthMap(surface->cascade);
  const Region region =
      regionOf(map, frame.kernel, {frame.read.filter, surface->u, surface->v, surface->footprint});
  QCOMPARE(ownRegion(report.probe).texels.size(), region.texels.size());
  const QPoint texel(region.x, region.y);
  QCOMPARE(window.evidence().map().canvas()->valueAt(texel), float(map(region.x, region.y)));
  key(Qt::Key_F7);
  QVERIFY(window.controller().session().frame.view == ViewMode::Cascades);
  settle();
}

void EditingTest::whatATableOfSumsCannotServeCannotBeChosen() {
  MainWindow& window = open();
  window.controller().edit("read",
                           [](Session& s) { s.frame.read.filter = ReadFilter::SummedArea; });
  settle();
  QVERIFY(window.prober().report().has_value());
  const QString reason = window.controller().refusals().value("power-cdf");
  QVERIFY(reason.contains("power-cdf"));
  QVERIFY(!window.controller().refusals().contains("vsm"));
  bool dash = false;
  const QAbstractItemModel& table = *window.evidence().table().view()->model();
  for (int row = 0; row < table.rowCount(); ++row)
    dash = dash || (table.index(row, 1).data().toString() == QString::fromUtf8("–") &&
                    table.index(row, 0).data(Qt::ToolTipRole).toString().contains(reason));
  QVERIFY(dash);
}

std::unique_ptr<QObject> makeEditingTest() {
  return std::make_unique<EditingTest>();
}

}  // namespace umbra

#include "EditingTest.moc"
