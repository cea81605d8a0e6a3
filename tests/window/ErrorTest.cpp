// The pane that takes the picture's error apart.
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "analysis/errors/BleedReduction.h"
#include "datasets/maps/ExrFile.h"
#include "tests/widgets/Mouse.h"
#include "tests/window/WindowFixture.h"
#include "ui/errors/ErrorController.h"
#include "ui/errors/ErrorPane.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/maps/PictureCanvas.h"
#include "ui/widgets/tables/ErrorTable.h"

namespace umbra {
namespace {

Session smallSession() {
  Session session;
  session.frame.map.size = 512;
  session.parameters["vsm"]["bleed-reduction"] = 0.1;
  return session;
}

ErrorController& errorsOf(MainWindow& window) {
  return *window.findChild<ErrorController*>();
}

// Raises the pane and waits until it has the present picture's figures.
ErrorPane& errorPaneOf(MainWindow& window) {
  window.findChild<QDockWidget*>("errorDock")->raise();
  if (!QTest::qWaitFor([&] { return errorsOf(window).current(); }, patience))
    qFatal("the error was not taken apart");
  return *window.findChild<ErrorPane*>();
}

// The request that a pixel's read makes, put together here.
ProbeRequest requestByHand(MainWindow& window, const SurfaceImage& surfaces, const DepthMap& map,
                           int x, int y) {
  const FrameSettings& settings = window.controller().session().frame;
  const SurfacePoint surface = surfaces.at(x, y).value();
  return {.map = map,
          .read = {settings.read.filter, surface.u, surface.v, {}},
          .kernel = settings.kernel,
          .receiver = surface.receiver};
}

Image<float> referenceByHand(MainWindow& window) {
  const SurfaceImage surfaces = window.view().lastFrame()->surfaces();
  const DepthMap map = window.view().lastFrame()->depthMap();
  Image<float> reference(surfaces.width(), surfaces.height(), 1, 1.0F);
  for (int y = 0; y < surfaces.height(); ++y)
    for (int x = 0; x < surfaces.width(); ++x)
      if (surfaces.receivesShadow(x, y))
        reference(x, y) = float(takeProbe(requestByHand(window, surfaces, map, x, y)).reference);
  return reference;
}

// Takes the error apart pixel by pixel, on one thread.
ErrorDecomposition takenByHand(MainWindow& window) {
  const SurfaceImage surfaces = window.view().lastFrame()->surfaces();
  const Image<float> reference = referenceByHand(window);
  const DepthMap map = window.view().lastFrame()->depthMap();
  const std::shared_ptr<Technique> technique = window.controller().technique().clone();
  technique->adapt(map);
  const auto techniques = decompositionTechniques(technique);
  ErrorDecomposition result = emptyDecomposition(surfaces.width(), surfaces.height());
  for (int y = 0; y < surfaces.height(); ++y)
    decomposeRow(
        surfaces, reference, y, techniques.size() > 1,
        [&](int x, int row) {
          ProbeRequest request = requestByHand(window, surfaces, map, x, row);
          request.techniques = techniques;
          return takeProbe(request);
        },
        {}, result);
  return result;
}

bool same(const ErrorSums& a, const ErrorSums& b) {
  return a.pixels == b.pixels && a.means == b.means && a.error == b.error;
}

QString cell(ErrorPane& pane, int row, int column) {
  return pane.table().item(row, column)->text();
}

// Draws a polygon with the mouse, in widget points of the canvas.
void draw(PictureCanvas& canvas, const QVector<QPoint>& points) {
  QTest::mousePress(&canvas, Qt::LeftButton, {}, points.front());
  for (const QPoint& point : points) moveMouse(&canvas, point, Qt::LeftButton);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, points.back());
}

// The polygon in pixels of the picture, as a mask.
Image<std::uint8_t> maskOf(const PictureCanvas& canvas, const QVector<QPoint>& points) {
  std::vector<LassoPoint> polygon;
  for (const QPoint& point : points) {
    const QPointF at = canvas.toPicture(point);
    polygon.push_back({at.x(), at.y()});
  }
  return lassoMask(polygon, canvas.picture().width(), canvas.picture().height());
}

QVector<QPoint> triangleIn(const PictureCanvas& canvas) {
  const int width = canvas.width(), height = canvas.height();
  return {{width / 4, height / 3}, {width * 3 / 4, height / 2}, {width / 3, height * 4 / 5}};
}

// Finds the pixel in `mask` whose `part` is largest in size.
Pixel worstByHand(const ErrorDecomposition& errors, ErrorPart part,
                  const Image<std::uint8_t>* mask = nullptr) {
  Pixel worst;
  for (int y = 0; y < errors.parts.height(); ++y)
    for (int x = 0; x < errors.parts.width(); ++x)
      if ((!mask || (*mask)(x, y)) && std::abs(errors.parts(x, y, int(part))) >
                                          std::abs(errors.parts(worst.x, worst.y, int(part))))
        worst = {x, y};
  return worst;
}

}  // namespace

class ErrorTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void theErrorIsTakenApartAsByHand();
  void aLassoCountsWhatItCircles();
  void aPixelOfTheErrorIsProbed();
  void theErrorOfAnEarlierPictureFades();
  void withoutAPictureTheErrorSaysWhy();
};

void ErrorTest::theErrorIsTakenApartAsByHand() {
  MainWindow& window = open(smallSession());
  ErrorPane& pane = errorPaneOf(window);
  const ErrorSums expected = sumsOf(takenByHand(window));
  QVERIFY(expected.means[std::size_t(ErrorPart::Bleeding)] > 0.001);
  QVERIFY(expected.means[std::size_t(ErrorPart::Reduction)] < 0.0);
  QVERIFY(same(errorsOf(window).frameSums(), expected));
  QVERIFY(!errorsOf(window).lassoSums());
  QCOMPARE(cell(pane, 0, 1), style::signedFigure(expected.error));
  for (int i = 0; i < errorPartCount; ++i)
    QCOMPARE(cell(pane, 1 + i, 1), style::signedFigure(expected.means[std::size_t(i)]));
  QCOMPARE(pane.canvas().picture().size(), window.view().pixels());
  QVERIFY(!pane.canvas().faded());
  QCOMPARE(pane.title(), style::text(window.controller().technique().info().title));

  pane.table().setFocus();
  QTest::keyClick(&pane.table(), Qt::Key_C, Qt::ControlModifier);
  const QStringList lines = QApplication::clipboard()->text().split('\n');
  QVERIFY(lines[0].startsWith(pane.title()));
  QCOMPARE(lines[1].split('\t')[1].toDouble(), expected.error);
  QCOMPARE(lines[8].split('\t')[1].toULongLong(), qulonglong(expected.pixels));

  // Another view of the same errors asks for nothing new; it has the same legend below.
  key(Qt::Key_F3);
  errorPaneOf(window);
  const auto taken = errorsOf(window).taken();
  key(Qt::Key_F4);
  QVERIFY(errorsOf(window).current());
  QCOMPARE(errorsOf(window).taken(), taken);
}

void ErrorTest::aLassoCountsWhatItCircles() {
  MainWindow& window = open(smallSession());
  ErrorPane& pane = errorPaneOf(window);
  PictureCanvas& canvas = pane.canvas();
  const QVector<QPoint> triangle = triangleIn(canvas);
  draw(canvas, triangle);
  const Image<std::uint8_t> mask = maskOf(canvas, triangle);
  const SurfaceImage surfaces = window.view().lastFrame()->surfaces();
  const Image<float> reference = referenceByHand(window);
  double error = 0.0;
  std::size_t pixels = 0;
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x) {
      if (!mask(x, y) || !surfaces.receivesShadow(x, y)) continue;
      error += double(surfaces.visibility(x, y)) - double(reference(x, y));
      ++pixels;
    }
  QVERIFY(pixels > 1000);
  const auto& sums = errorsOf(window).lassoSums();
  QVERIFY(sums.has_value());
  QCOMPARE(sums->pixels, pixels);
  // Sums of at most 10⁶ doubles below 1, in another order.
  QVERIFY(std::abs(sums->error - error / double(pixels)) < 1e-10);
  QCOMPARE(cell(pane, 0, 2), style::signedFigure(sums->error));
  QCOMPARE(window.controller().undoStack().count(), 0);  // no click
  // The lasso is outlined over the scene as well, at the same place of the picture.
  const QPolygonF outline = window.view().overlayContents().selection;
  QCOMPARE(outline.size(), triangle.size());
  const QPointF corner = canvas.toPicture(triangle[1]) / window.view().devicePixelRatioF();
  QVERIFY(std::hypot((outline[1] - corner).x(), (outline[1] - corner).y()) < 1e-9);

  canvas.setFocus();
  QTest::keyClick(&canvas, Qt::Key_Escape);
  QVERIFY(!errorsOf(window).lassoSums());
  QCOMPARE(cell(pane, 0, 2), QString());
  QVERIFY(window.view().overlayContents().selection.isEmpty());
  QVERIFY(window.controller().session().probe.has_value());  // Escape was the lasso's
  draw(canvas, triangle);
  window.findChild<QToolButton*>("clearLasso")->click();
  QVERIFY(!errorsOf(window).lassoSums());
}

void ErrorTest::aPixelOfTheErrorIsProbed() {
  MainWindow& window = open(smallSession());
  ErrorPane& pane = errorPaneOf(window);
  PictureCanvas& canvas = pane.canvas();
  const QPoint point(canvas.width() / 2, canvas.height() * 3 / 4);
  const QPointF at = canvas.toPicture(point);
  moveMouse(&canvas, point);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, point);
  settle();
  const Pixel clicked{int(std::floor(at.x())), int(std::floor(at.y()))};
  QVERIFY(window.controller().session().probe == clicked);
  QVERIFY(window.prober().report()->pixel == clicked);
  QVERIFY(errorsOf(window).current());  // a probe changes no error
  // A click leaves the figures of the pixel under the pointer.
  const QString readout = window.findChild<QLabel*>("errorReadout")->text();
  QVERIFY(readout.contains(QString("%1, %2:").arg(clicked.x).arg(clicked.y)));
  QVERIFY(readout.contains(
      style::signedFigure(*result("vsm").gpu - window.prober().report()->probe.reference)));

  const ErrorDecomposition& errors = errorsOf(window).taken()->errors;
  auto* worst = window.findChild<QToolButton*>("worstError");
  pane.table().setCurrentCell(1 + int(ErrorPart::Reduction), 0);
  QVERIFY(errorsOf(window).part() == ErrorPart::Reduction);
  worst->click();
  settle();
  QVERIFY(window.prober().report()->pixel == worstByHand(errors, ErrorPart::Reduction));
  pane.table().setCurrentCell(1 + int(ErrorPart::Bleeding), 0);
  const QVector<QPoint> triangle = triangleIn(canvas);
  draw(canvas, triangle);
  const Image<std::uint8_t> mask = maskOf(canvas, triangle);
  worst->click();
  settle();
  QVERIFY(window.prober().report()->pixel == worstByHand(errors, ErrorPart::Bleeding, &mask));
  QCOMPARE(window.controller().undoStack().count(), 3);  // each a step
}

void ErrorTest::theErrorOfAnEarlierPictureFades() {
  MainWindow& window = open(smallSession());
  ErrorPane& pane = errorPaneOf(window);
  const ErrorSums before = errorsOf(window).frameSums();
  auto* worst = window.findChild<QToolButton*>("worstError");
  QVERIFY(worst->isEnabled());
  bool faded = false, pinnable = false;
  connect(&errorsOf(window), &ErrorController::changed, this, [&] {
    if (errorsOf(window).current()) return;
    faded = pane.canvas().faded() && !pane.canvas().shownText().isEmpty();
    pinnable = pinnable || worst->isEnabled();
  });
  window.controller().edit(
      "Reduce", [](Session& session) { session.parameters["vsm"]["bleed-reduction"] = 0.5; });
  settle();
  errorPaneOf(window);
  QVERIFY(faded);
  QVERIFY(!pinnable);
  QVERIFY(!pane.canvas().faded());
  QVERIFY(pane.canvas().shownText().isEmpty());
  QVERIFY(same(errorsOf(window).frameSums(), sumsOf(takenByHand(window))));
  QVERIFY(errorsOf(window).frameSums().error < before.error);
}

void ErrorTest::withoutAPictureTheErrorSaysWhy() {
  MainWindow& window = open(smallSession());
  ErrorPane& pane = errorPaneOf(window);
  window.prober().setVeil("Predict first.");
  QVERIFY(pane.canvas().picture().isNull());
  QCOMPARE(pane.canvas().shownText(), QString("Predict first."));
  QCOMPARE(cell(pane, 0, 1), QString());
  QVERIFY(pane.table().asText().isEmpty());
  window.prober().setVeil({});
  QTRY_VERIFY_WITH_TIMEOUT(!pane.canvas().picture().isNull(), patience);
  const QString file = folder_.filePath("no-picture.exr");
  writeExr(file.toStdString(), {{"Z", Image<float>(16, 16, 1, 0.5F)}}, {});
  window.openFile(file.toStdString());
  QTRY_VERIFY_WITH_TIMEOUT(window.controller().document().content.depth != nullptr, patience);
  QVERIFY(pane.canvas().picture().isNull());
  QVERIFY(pane.canvas().shownText().contains("depth map"));
  QCOMPARE(cell(pane, 0, 1), QString());
}

std::unique_ptr<QObject> makeErrorTest() {
  return std::make_unique<ErrorTest>();
}

}  // namespace umbra

#include "ErrorTest.moc"
