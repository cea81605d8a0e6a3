#include "ui/widgets/maps/ShadowMapView.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/ExampleProbe.h"
#include "ui/widgets/maps/ShadowMapCanvas.h"

namespace umbra {
namespace {

TEST(ShadowMapView, TakesOneChannelOutOfInterleavedOnes) {
  Image<float> moments(3, 2, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) {
      moments(x, y, 0) = float(x);
      moments(x, y, 1) = float(10 * y + x);
    }
  ShadowMapView view;
  view.setImage(moments, 1);
  EXPECT_EQ(view.canvas()->valueAt({2, 1}), 12.0F);
  EXPECT_EQ(view.canvas()->high(), 12.0);
  view.setImage(moments, 0);
  EXPECT_EQ(view.canvas()->valueAt({2, 1}), 2.0F);
}

TEST(ShadowMapView, ChannelIsChosenByAPersonOnly) {
  ShadowMapView view;
  QSignalSpy chosen(&view, &ShadowMapView::channelChosen);
  view.setChannels({"depth", "M1", "M2"}, "M1");
  EXPECT_EQ(view.currentChannel(), "M1");
  EXPECT_EQ(chosen.count(), 0);
  view.show();
  QTest::keyClick(view.findChildren<QComboBox*>().first(), Qt::Key_Down);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toString(), "M2");
}

TEST(ShadowMapView, ClearedViewHasNoTexels) {
  ShadowMapView view;
  view.resize(260, 320);
  view.show();
  view.setImage(DepthMap(8, 8, 1, 0.25));
  view.setRegion(regionAround(4, 4, 1));
  EXPECT_TRUE(view.canvas()->texelAt(QRectF(view.canvas()->rect()).center()));
  view.clear();
  EXPECT_FALSE(view.canvas()->texelAt(QRectF(view.canvas()->rect()).center()));
  EXPECT_FALSE(view.grab().isNull());
}

}  // namespace
}  // namespace umbra
