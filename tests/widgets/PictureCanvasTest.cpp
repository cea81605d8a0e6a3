#include "ui/widgets/maps/PictureCanvas.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/widgets/Grab.h"
#include "tests/widgets/Mouse.h"

namespace umbra {
namespace {

// 40 × 20 pixels on 200 × 200: five widget pixels to one, with room above and below.
class PictureCanvasTest : public testing::Test {
 protected:
  PictureCanvasTest() {
    QImage picture(40, 20, QImage::Format_RGB32);
    picture.fill(Qt::white);
    picture.setPixel(30, 10, qRgb(200, 0, 0));
    canvas.resize(200, 200);
    canvas.show();
    canvas.setPicture(picture);
  }

  void wheel(const QPoint& at, int steps) {
    QWheelEvent event(at, canvas.mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas, &event);
  }

  PictureCanvas canvas;
};

TEST_F(PictureCanvasTest, FitsItsPicture) {
  EXPECT_EQ(canvas.toWidget({0.0, 0.0}), QPointF(0.0, 50.0));
  EXPECT_EQ(canvas.toWidget({40.0, 20.0}), QPointF(200.0, 150.0));
  EXPECT_EQ(canvas.toPicture({152.5, 102.5}), QPointF(30.5, 10.5));
  const Grab shown(canvas);
  EXPECT_EQ(shown(152, 102), qRgb(200, 0, 0));
  EXPECT_EQ(shown(142, 102), qRgb(255, 255, 255));
}

TEST_F(PictureCanvasTest, NamesThePixelUnderThePointer) {
  QSignalSpy hovered(&canvas, &PictureCanvas::pixelHovered), left(&canvas, &PictureCanvas::left);
  moveMouse(&canvas, {152, 102});
  ASSERT_EQ(hovered.size(), 1);
  EXPECT_EQ(hovered[0][0].toInt(), 30);
  EXPECT_EQ(hovered[0][1].toInt(), 10);
  moveMouse(&canvas, {152, 30});
  EXPECT_EQ(left.size(), 1);
  EXPECT_EQ(hovered.size(), 1);
}

TEST_F(PictureCanvasTest, AClickNamesAPixelAndADragALasso) {
  QSignalSpy clicked(&canvas, &PictureCanvas::pixelClicked),
      drawn(&canvas, &PictureCanvas::lassoDrawn);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, {12, 52});
  ASSERT_EQ(clicked.size(), 1);
  EXPECT_EQ(clicked[0][0].toInt(), 2);
  EXPECT_EQ(clicked[0][1].toInt(), 0);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, {12, 20});  // beside the picture
  EXPECT_EQ(clicked.size(), 1);

  QTest::mousePress(&canvas, Qt::LeftButton, {}, {10, 60});
  for (const QPoint& to : {QPoint(100, 60), QPoint(100, 140)})
    moveMouse(&canvas, to, Qt::LeftButton);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, {100, 140});
  EXPECT_EQ(clicked.size(), 1);
  ASSERT_EQ(drawn.size(), 1);
  EXPECT_EQ(drawn[0][0].value<QPolygonF>(), QPolygonF({{2, 2}, {20, 2}, {20, 18}}));
}

TEST_F(PictureCanvasTest, EscapeEndsADrag) {
  QSignalSpy drawn(&canvas, &PictureCanvas::lassoDrawn);
  QTest::mousePress(&canvas, Qt::LeftButton, {}, {10, 60});
  moveMouse(&canvas, {100, 60}, Qt::LeftButton);
  moveMouse(&canvas, {100, 140}, Qt::LeftButton);
  QTest::keyClick(&canvas, Qt::Key_Escape);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, {100, 140});
  EXPECT_EQ(drawn.size(), 0);
}

TEST_F(PictureCanvasTest, TheWheelMagnifiesAboutThePointer) {
  const QPointF under = canvas.toPicture({152.0, 102.0});
  wheel({152, 102}, 4);
  EXPECT_NEAR(canvas.toWidget(under).x(), 152.0, 1e-9);
  EXPECT_NEAR(canvas.toWidget(under).y(), 102.0, 1e-9);
  // Four steps of a factor √2 each.
  EXPECT_NEAR(canvas.toWidget(under + QPointF(1.0, 0.0)).x(), 172.0, 1e-9);
  wheel({10, 60}, -20);
  EXPECT_EQ(canvas.toWidget({0.0, 0.0}), QPointF(0.0, 50.0));
}

TEST_F(PictureCanvasTest, AThinLineOutlastsShrinking) {
  QImage wide(2000, 1000, QImage::Format_RGB32);
  wide.fill(Qt::white);
  for (int y = 0; y < 1000; ++y) wide.setPixel(1003, y, qRgb(0, 0, 0));
  canvas.setPicture(wide);
  const Grab shown(canvas);
  // One of ten columns, or of five at twice the density, is black: a tenth or a fifth darker.
  EXPECT_LT(qGray(shown(100, 100)), 240);
  EXPECT_EQ(qGray(shown(60, 100)), 255);
}

TEST_F(PictureCanvasTest, WithoutAPictureItSaysWhy) {
  canvas.setHint("why");
  EXPECT_EQ(canvas.shownText(), QString());
  canvas.setPicture({});
  EXPECT_EQ(canvas.shownText(), QString("why"));
  QSignalSpy clicked(&canvas, &PictureCanvas::pixelClicked);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, {100, 100});
  EXPECT_EQ(clicked.size(), 0);
}

}  // namespace
}  // namespace umbra
