#include <gtest/gtest.h>

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "filters/gpu/ViewColours.h"
#include "tests/widgets/Grab.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/maps/ColourBar.h"
#include "ui/widgets/maps/ColourMap.h"

namespace umbra {
namespace {

TEST(ColourMap, DivergingIsWhiteAtZeroBlueBelowAndRedAbove) {
  const QRgb middle = colourAt(ColourMap::Diverging, 0.5);
  EXPECT_GE(std::min({qRed(middle), qGreen(middle), qBlue(middle)}), 253);
  EXPECT_GT(qBlue(colourAt(ColourMap::Diverging, 0.2)), qRed(colourAt(ColourMap::Diverging, 0.2)));
  EXPECT_GT(qRed(colourAt(ColourMap::Diverging, 0.8)), qBlue(colourAt(ColourMap::Diverging, 0.8)));
}

TEST(ColourMap, SequentialMapsGetLighterAllTheWay) {
  for (ColourMap map : {ColourMap::Viridis, ColourMap::Grey}) {
    const auto& table = colourTable(map);
    for (std::size_t i = 1; i < table.size(); ++i)
      EXPECT_GE(qGray(table[i]) + 1, qGray(table[i - 1])) << "entry " << i;
    EXPECT_GT(qGray(table[255]), qGray(table[0]) + 150);
  }
}

TEST(ColourMap, ValuesBeyondTheEndsTakeTheEndsColour) {
  EXPECT_EQ(colourAt(ColourMap::Viridis, -3.0), qRgb(0x44, 0x01, 0x54));
  EXPECT_EQ(colourAt(ColourMap::Viridis, 7.0), qRgb(0xfd, 0xe7, 0x25));
}

FrameSettings showing(ViewMode mode) {
  FrameSettings settings;
  settings.view = mode;
  return settings;
}

TEST(ColourBar, IsThereForTheModesWhoseColoursAreAScale) {
  ColourBar bar;
  for (ViewMode mode : {ViewMode::Visibility, ViewMode::Error, ViewMode::Depth}) {
    bar.setView(showing(mode));
    EXPECT_FALSE(bar.isHidden());
  }
  for (ViewMode mode : {ViewMode::Shaded, ViewMode::Layers}) {
    bar.setView(showing(mode));
    EXPECT_TRUE(bar.isHidden());
  }
}

// The colours of the bar are those of the picture, end for end.
TEST(ColourBar, OfDepthsIsAsGreyAsThePicture) {
  ColourBar bar;
  bar.setView(showing(ViewMode::Depth));
  bar.resize(201, 40);
  EXPECT_TRUE(bar.toolTip().endsWith("1 … 0")) << bar.toolTip().toStdString();
  const Grab shown(bar);
  const int top = bar.fontMetrics().height() + 4;
  for (const double z : {0.95, 0.5, 0.05}) {
    const QRgb pixel = shown(int(200 * (1.0 - z)), top);
    const int grey = int(std::lround(255.0 * double(colourOfDepth(z)[0])));
    for (const int part : {qRed(pixel), qGreen(pixel), qBlue(pixel)})
      EXPECT_NEAR(part, grey, 4) << z;
  }
}

TEST(ColourBar, ANoticeTakesThePlaceOfAScale) {
  ColourBar bar;
  bar.setView(showing(ViewMode::Visibility));
  const int tall = bar.sizeHint().height();
  bar.setNotice("There is nothing to show");
  EXPECT_FALSE(bar.isHidden());
  EXPECT_LT(bar.sizeHint().height(), tall);
  bar.setView(showing(ViewMode::Visibility));
  EXPECT_EQ(bar.sizeHint().height(), tall);
}

TEST(ColourBar, OfErrorsEndsAtTheRangeThatIsSet) {
  ColourBar bar;
  FrameSettings settings = showing(ViewMode::Error);
  settings.errorRange = 0.1;
  bar.setView(settings);
  EXPECT_TRUE(bar.toolTip().contains(style::figure(0.1))) << bar.toolTip().toStdString();
}

TEST(ColourBar, DrawsItsMapFromLeftToRight) {
  ColourBar bar;
  bar.setScale(ColourMap::Grey, 0.0, 1.0, QString());
  bar.resize(200, 40);
  const Grab shown(bar);
  EXPECT_LT(qGray(shown(4, 5)), 30);
  EXPECT_NEAR(qGray(shown(100, 5)), 128, 6);
  EXPECT_GT(qGray(shown(195, 5)), 225);
}

TEST(Style, FiguresAlign) {
  const QFont font = style::figures(QFont("Inter", 10));
  const QFontMetricsF metrics(font);
  EXPECT_NEAR(metrics.horizontalAdvance("1111"), metrics.horizontalAdvance("0000"), 0.2);
}

TEST(Style, ErrorsCarryASignUnlessTheyRoundToZero) {
  EXPECT_EQ(style::signedFigure(0.2264), "+0.226");
  EXPECT_EQ(style::signedFigure(-0.031), "−0.031");
  EXPECT_EQ(style::signedFigure(-0.0001), "+0.000");
}

}  // namespace
}  // namespace umbra
