#include "ui/widgets/maps/ShadowMapCanvas.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <limits>
#include <utility>

#include "tests/widgets/ExampleProbe.h"
#include "tests/widgets/Grab.h"
#include "tests/widgets/Mouse.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int side = 240;

class ShadowMapCanvasTest : public testing::Test {
 protected:
  ShadowMapCanvasTest() {
    canvas.resize(side, side);
    canvas.show();
    canvas.setColourMap(ColourMap::Grey);
    canvas.setValues(numberedMap(16, 16));
  }

  QRgb greyOf(const QPoint& texel) const {
    const double share = (canvas.valueAt(texel) - canvas.low()) / (canvas.high() - canvas.low());
    return qRgb(int(1 + share * 254), int(1 + share * 254), int(1 + share * 254));
  }

  ShadowMapCanvas canvas;
};

bool isAmber(QRgb colour) {
  return std::abs(qRed(colour) - style::probe.red()) < 12 &&
         std::abs(qGreen(colour) - style::probe.green()) < 12 &&
         std::abs(qBlue(colour) - style::probe.blue()) < 30;
}

TEST_F(ShadowMapCanvasTest, FitsTheWholeMapAtFirst) {
  EXPECT_EQ(canvas.scale(), 15.0);
  EXPECT_EQ(canvas.texelAt({0.5, 0.5}), QPoint(0, 0));
  EXPECT_EQ(canvas.texelAt({side - 0.5, side - 0.5}), QPoint(15, 15));
  canvas.resize(480, 480);
  EXPECT_EQ(canvas.scale(), 30.0);
}

// Neighbours differ by far more than a grey level.
Image<float> scrambledMap(int size) {
  Image<float> map(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) map(x, y) = float((x * 37 + y * 59) % 64) / 63.0F;
  return map;
}

// The colour drawn at a point is that of the texel which texelAt names there. Where texels are
// large enough for grid lines, their edges are left out.
TEST_F(ShadowMapCanvasTest, DrawsTheTexelThatItNamesAtEveryZoom) {
  for (const auto& [size, factor] :
       {std::pair{100, 1.0}, {100, 1.37}, {100, 2.3}, {16, 1.0}, {16, 1.7}, {16, 2.9}}) {
    canvas.setValues(scrambledMap(size));
    canvas.fit();
    canvas.zoomAbout({70.0, 150.0}, factor);
    const double margin = canvas.scale() > 6.0 ? 1.0 : 0.0;
    const Grab shown(canvas);
    int compared = 0;
    for (int y = 1; y < shown.devicePixels().height(); y += 3)
      for (int x = 1; x < shown.devicePixels().width(); x += 3) {
        const QPointF point = QPointF(x + 0.5, y + 0.5) / shown.ratio();
        const auto texel = canvas.texelAt(point);
        ASSERT_TRUE(texel);
        const QRectF cell = canvas.rectOfTexels({*texel, QSize(1, 1)});
        // Double rounding may put a point that lies on an edge to either side of it.
        EXPECT_TRUE(cell.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(point));
        if (!cell.adjusted(margin, margin, -margin, -margin).contains(point)) continue;
        EXPECT_LE(std::abs(qRed(shown.devicePixel(x, y)) - qRed(greyOf(*texel))), 1)
            << "pixel " << x << ", " << y << " at " << canvas.scale() << " pixels a texel";
        ++compared;
      }
    EXPECT_GT(compared, 1000) << canvas.scale();
  }
}

TEST_F(ShadowMapCanvasTest, ZoomKeepsTheTexelUnderTheCursor) {
  const QPointF cursor(77.5, 191.5);
  const auto before = canvas.texelAt(cursor);
  for (int i = 0; i < 6; ++i) {
    canvas.zoomAbout(cursor, 1.4);
    EXPECT_EQ(canvas.texelAt(cursor), before);
  }
}

TEST_F(ShadowMapCanvasTest, HoverAndClickNameTheTexel) {
  QSignalSpy hovered(&canvas, &ShadowMapCanvas::texelHovered);
  QSignalSpy clicked(&canvas, &ShadowMapCanvas::texelClicked);
  canvas.zoomAbout({120.0, 120.0}, 2.0);
  const QPoint place = canvas.rectOfTexels({6, 9, 1, 1}).center().toPoint();
  moveMouse(&canvas, place);
  ASSERT_EQ(hovered.count(), 1);
  EXPECT_EQ(hovered.last()[0].toInt(), 6);
  EXPECT_EQ(hovered.last()[1].toInt(), 9);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, place);
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked[0][0].toInt(), 6);
  EXPECT_EQ(clicked[0][1].toInt(), 9);
}

TEST_F(ShadowMapCanvasTest, DragMovesTheMapAndClicksNothing) {
  QSignalSpy clicked(&canvas, &ShadowMapCanvas::texelClicked);
  canvas.zoomAbout({120.0, 120.0}, 3.0);
  const auto under = canvas.texelAt({100.5, 100.5});
  QTest::mousePress(&canvas, Qt::LeftButton, {}, {100, 100});
  moveMouse(&canvas, {130, 80}, Qt::LeftButton);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, {130, 80});
  EXPECT_EQ(canvas.texelAt({130.5, 80.5}), under);
  EXPECT_EQ(clicked.count(), 0);
}

TEST_F(ShadowMapCanvasTest, DoubleClickShowsTheWholeMap) {
  canvas.zoomAbout({10.0, 10.0}, 5.0);
  QTest::mouseDClick(&canvas, Qt::LeftButton, {}, {50, 50});
  EXPECT_EQ(canvas.scale(), 15.0);
}

TEST_F(ShadowMapCanvasTest, OutlinesTheRegionWhereItIs) {
  canvas.setRegion(regionAround(8, 6, 2));
  EXPECT_EQ(canvas.regionTexels(), QRect(6, 4, 5, 5));
  const QRectF outline = canvas.rectOfTexels(canvas.regionTexels());
  EXPECT_EQ(outline, QRectF(90, 60, 75, 75));
  const Grab shown(canvas);
  EXPECT_TRUE(isAmber(shown(90, 72)));
  EXPECT_TRUE(isAmber(shown(164, 72)));
  EXPECT_TRUE(isAmber(shown(100, 60)));
  EXPECT_TRUE(isAmber(shown(100, 134)));
  EXPECT_FALSE(isAmber(shown(80, 72)));
  EXPECT_FALSE(isAmber(shown(100, 72)));
  const QPoint centre = canvas.rectOfTexels({8, 6, 1, 1}).center().toPoint();
  EXPECT_TRUE(isAmber(shown(centre.x(), centre.y())));
  canvas.setRegion(std::nullopt);
  EXPECT_FALSE(isAmber(Grab(canvas)(90, 72)));
}

TEST_F(ShadowMapCanvasTest, RegionFillsTwoThirdsOfTheView) {
  canvas.setValues(numberedMap(64, 64));
  canvas.setRegion(regionAround(40, 20, 3));
  canvas.showRegion();
  const QRectF outline = canvas.rectOfTexels(canvas.regionTexels());
  EXPECT_NEAR(outline.width(), side * 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(outline.center().x(), side / 2.0, 1e-9);
  EXPECT_NEAR(outline.center().y(), side / 2.0, 1e-9);
}

TEST_F(ShadowMapCanvasTest, RangeIsThatOfTheFiniteValues) {
  Image<float> map(2, 2);
  map(0, 0) = std::numeric_limits<float>::quiet_NaN();
  map(1, 0) = std::numeric_limits<float>::infinity();
  map(0, 1) = -2.0F;
  map(1, 1) = 3.0F;
  canvas.setValues(map);
  EXPECT_EQ(canvas.low(), -2.0);
  EXPECT_EQ(canvas.high(), 3.0);
  EXPECT_FALSE(canvas.grab().isNull());
}

TEST_F(ShadowMapCanvasTest, NewValuesOfTheSameSizeKeepTheZoom) {
  canvas.zoomAbout({50.0, 60.0}, 2.5);
  const double scale = canvas.scale();
  canvas.setValues(numberedMap(16, 16));
  EXPECT_EQ(canvas.scale(), scale);
  canvas.setValues(numberedMap(32, 32));
  EXPECT_EQ(canvas.scale(), 7.5);
}

}  // namespace
}  // namespace umbra
