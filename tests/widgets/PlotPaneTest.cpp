#include "ui/widgets/plots/PlotPane.h"

#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_scale_widget.h>

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "analysis/plots/ProbePlots.h"
#include "filters/core/support/Error.h"
#include "tests/widgets/Mouse.h"

namespace umbra {
namespace {

Plot examplePlot() {
  Plot plot;
  plot.name = "curves";
  plot.title = "Visibility of the region";
  plot.xLabel = "light-space depth z (normalised)";
  plot.yLabel = "v(z)";
  plot.xRange = plot.yRange = PlotRange{0.0, 1.0};
  plot.series = {{"VSM", "#2563c9", SeriesStyle::Line, {0.0, 0.5, 1.0}, {1.0, 1.0, 0.0}}};
  plot.markers = {{MarkerAxis::Vertical, 0.25, "mean", "#6b7785"},
                  {MarkerAxis::Vertical, 0.75, "receiver", std::string(probeColour), true, true}};
  return plot;
}

class PlotPaneTest : public testing::Test {
 protected:
  PlotPaneTest() {
    pane.resize(480, 320);
    pane.setPlot(examplePlot());
    pane.show();
    pane.canvas()->replot();
  }

  QPoint at(double x) {
    const double pixel = pane.canvas()->transform(QwtPlot::xBottom, x);
    return {int(std::lround(pixel)), pane.canvas()->canvas()->height() / 2};
  }
  QByteArray saved(const QString& name) {
    const QString file = folder.filePath(name);
    pane.save(file.toStdString());
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
  }

  PlotPane pane;
  QTemporaryDir folder;
};

TEST_F(PlotPaneTest, TitleIsTheCards) {
  EXPECT_EQ(pane.title(), "Visibility of the region");
  EXPECT_TRUE(pane.canvas()->title().text().isEmpty());
}

TEST_F(PlotPaneTest, SavesEveryFormat) {
  EXPECT_TRUE(saved("plot.svg").contains("<svg"));
  EXPECT_TRUE(saved("plot.svg").contains("Visibility of the region"));
  EXPECT_TRUE(saved("plot.pdf").startsWith("%PDF"));
  const QImage picture = QImage::fromData(saved("plot.png"));
  EXPECT_GT(picture.width(), 720);
  EXPECT_EQ(saved("plot.csv"), QByteArray::fromStdString(toCsv(examplePlot())));
}

TEST_F(PlotPaneTest, RefusesWhatItCannotWrite) {
  EXPECT_THROW(pane.save(folder.filePath("plot.xyz").toStdString()), Error);
  pane.clear("Click a pixel.");
  EXPECT_THROW(pane.save(folder.filePath("plot.svg").toStdString()), Error);
  EXPECT_FALSE(QFile::exists(folder.filePath("plot.svg")));
}

TEST_F(PlotPaneTest, CopiesThePicture) {
  pane.copy();
  EXPECT_GE(QGuiApplication::clipboard()->image().width(), pane.canvas()->width());
}

TEST_F(PlotPaneTest, ReceiversMarkerIsDragged) {
  QSignalSpy dragged(&pane, &PlotPane::depthDragged);
  QSignalSpy finished(&pane, &PlotPane::depthDragFinished);
  QWidget* canvas = pane.canvas()->canvas();
  const double pixel = pane.canvas()->invTransform(QwtPlot::xBottom, 1) -
                       pane.canvas()->invTransform(QwtPlot::xBottom, 0);
  QTest::mousePress(canvas, Qt::LeftButton, {}, at(0.75));
  moveMouse(canvas, at(0.4), Qt::LeftButton);
  ASSERT_GE(dragged.count(), 1);
  EXPECT_NEAR(dragged.last()[0].toDouble(), 0.4, pixel);
  moveMouse(canvas, {-50, 20}, Qt::LeftButton);
  EXPECT_EQ(dragged.last()[0].toDouble(), 0.0);
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, at(0.4));
  EXPECT_EQ(finished.count(), 1);
}

TEST_F(PlotPaneTest, TheDepthAxisTakesTheReceiverWhereverItIsPressed) {
  QSignalSpy dragged(&pane, &PlotPane::depthDragged);
  QSignalSpy finished(&pane, &PlotPane::depthDragFinished);
  QWidget* canvas = pane.canvas()->canvas();
  QWidget* axis = pane.canvas()->axisWidget(QwtPlot::xBottom);
  const auto below = [&](double depth) {
    return QPoint(axis->mapFromGlobal(canvas->mapToGlobal(at(depth))).x(), axis->height() / 2);
  };
  const double pixel = pane.canvas()->invTransform(QwtPlot::xBottom, 1) -
                       pane.canvas()->invTransform(QwtPlot::xBottom, 0);
  QTest::mousePress(axis, Qt::LeftButton, {}, below(0.2));
  ASSERT_EQ(dragged.count(), 1);
  EXPECT_NEAR(dragged.last()[0].toDouble(), 0.2, pixel);
  moveMouse(axis, below(0.6), Qt::LeftButton);
  EXPECT_NEAR(dragged.last()[0].toDouble(), 0.6, pixel);
  QTest::mouseRelease(axis, Qt::LeftButton, {}, below(0.6));
  EXPECT_EQ(finished.count(), 1);
  // A plot without a receiver has nothing to move.
  Plot plain = examplePlot();
  plain.markers.clear();
  pane.setPlot(plain);
  dragged.clear();
  QTest::mousePress(axis, Qt::LeftButton, {}, below(0.2));
  QTest::mouseRelease(axis, Qt::LeftButton, {}, below(0.2));
  EXPECT_EQ(dragged.count(), 0);
}

TEST_F(PlotPaneTest, DraggableMarkersAreDraggedByTheirNumber) {
  Plot plot = examplePlot();
  plot.markers.push_back({MarkerAxis::Vertical, 0.5, "s1", "#7b4fa3", false, true});
  pane.setPlot(plot);
  pane.canvas()->replot();
  QSignalSpy dragged(&pane, &PlotPane::markerDragged);
  QSignalSpy finished(&pane, &PlotPane::markerDragFinished);
  QSignalSpy receiver(&pane, &PlotPane::depthDragged);
  QWidget* canvas = pane.canvas()->canvas();
  const double pixel = pane.canvas()->invTransform(QwtPlot::xBottom, 1) -
                       pane.canvas()->invTransform(QwtPlot::xBottom, 0);
  QTest::mousePress(canvas, Qt::LeftButton, {}, at(0.5));
  moveMouse(canvas, at(0.3), Qt::LeftButton);
  ASSERT_GE(dragged.count(), 1);
  EXPECT_EQ(dragged.last()[0].toInt(), 2);
  EXPECT_NEAR(dragged.last()[1].toDouble(), 0.3, pixel);
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, at(0.3));
  EXPECT_EQ(finished.count(), 1);
  EXPECT_EQ(receiver.count(), 0);
}

TEST_F(PlotPaneTest, ABandLiesBehindItsStretchAlone) {
  Plot plot = examplePlot();
  plot.series.clear();
  plot.markers.clear();
  plot.bands = {{0.5, 1.0, "layer 2", "#ff0000"}};
  pane.setPlot(plot);
  pane.canvas()->replot();
  const QImage picture = pane.canvas()->canvas()->grab().toImage();
  const double ratio = picture.devicePixelRatio();
  // This point lies off the grid's lines.
  const QColor outside = picture.pixelColor(at(0.33) * ratio);
  const QColor inside = picture.pixelColor(at(0.77) * ratio);
  EXPECT_EQ(outside.red(), outside.green());
  EXPECT_GT(inside.red(), inside.green());
}

TEST_F(PlotPaneTest, OtherMarkersStay) {
  QSignalSpy dragged(&pane, &PlotPane::depthDragged);
  QWidget* canvas = pane.canvas()->canvas();
  QTest::mousePress(canvas, Qt::LeftButton, {}, at(0.25));
  moveMouse(canvas, at(0.6), Qt::LeftButton);
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, at(0.6));
  EXPECT_EQ(dragged.count(), 0);
}

}  // namespace
}  // namespace umbra
