#include "filters/core/maps/SurfaceImage.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbra {
namespace {

// One pixel as the shading pass writes it.
SurfaceImage codedAs(float u, float v, float receiver, float visibility = 0.25F) {
  Image<float> surfaces(1, 1, 4);
  const float values[] = {u, v, receiver, visibility};
  std::ranges::copy(values, surfaces.pixel(0, 0).begin());
  return {surfaces, {}};
}

TEST(SurfaceImage, TheSignOfTheReceiverSaysWhichWayTheSurfaceFaces) {
  const SurfaceImage towards = codedAs(0.5F, 0.25F, 0.75F), away = codedAs(0.5F, 0.25F, -0.75F);
  for (const SurfaceImage& image : {towards, away}) {
    const auto surface = image.at(0, 0);
    ASSERT_TRUE(surface);
    EXPECT_EQ(surface->u, 0.5);
    EXPECT_EQ(surface->v, 0.25);
    EXPECT_EQ(surface->receiver, 0.75);
    EXPECT_EQ(surface->visibility, 0.25);
    EXPECT_EQ(image.receiver(0, 0), 0.75F);
    EXPECT_EQ(image.visibility(0, 0), 0.25F);
    EXPECT_EQ(surface->receivesShadow(), image.receivesShadow(0, 0));
  }
  EXPECT_TRUE(towards.at(0, 0)->facesLight);
  EXPECT_TRUE(towards.receivesShadow(0, 0));
  EXPECT_FALSE(away.at(0, 0)->facesLight);
  EXPECT_FALSE(away.receivesShadow(0, 0));
}

// A bias that is larger than the surface's depth leaves a receiver of exactly 0.
TEST(SurfaceImage, AReceiverOfZeroFacesTheLightUnlessItsSignBitIsSet) {
  const SurfaceImage towards = codedAs(0.5F, 0.5F, 0.0F), away = codedAs(0.5F, 0.5F, -0.0F);
  EXPECT_EQ(towards.at(0, 0)->receiver, 0.0);
  EXPECT_EQ(away.at(0, 0)->receiver, 0.0);
  EXPECT_TRUE(towards.at(0, 0)->facesLight);
  EXPECT_TRUE(towards.receivesShadow(0, 0));
  EXPECT_FALSE(away.at(0, 0)->facesLight);
  EXPECT_FALSE(away.receivesShadow(0, 0));
}

TEST(SurfaceImage, WhatLeavesTheMapReceivesNoShadow) {
  for (const float outside : {-0.5F, 1.5F}) {
    EXPECT_FALSE(codedAs(0.5F, outside, 0.5F).receivesShadow(0, 0));
    EXPECT_TRUE(codedAs(0.5F, outside, 0.5F).shows(0, 0));
  }
  EXPECT_TRUE(codedAs(1.5F, 0.5F, 0.5F).shows(0, 0));
  EXPECT_FALSE(codedAs(1.5F, 0.5F, 0.5F).at(0, 0)->isInMap());
  for (const float border : {0.0F, 1.0F}) {
    EXPECT_TRUE(codedAs(border, border, 0.5F).at(0, 0)->isInMap());
    EXPECT_TRUE(codedAs(border, border, 0.5F).receivesShadow(0, 0));
  }
}

TEST(SurfaceImage, APixelOfTheSkyOrOutsideShowsNothing) {
  const SurfaceImage image(3, 2);
  for (int y = -1; y <= 2; ++y)
    for (int x = -1; x <= 3; ++x) {
      EXPECT_FALSE(image.shows(x, y));
      EXPECT_FALSE(image.at(x, y));
      EXPECT_FALSE(image.receivesShadow(x, y));
    }
  EXPECT_EQ(image.visibility(2, 1), 1.0F);
  EXPECT_EQ(image.receiver(2, 1), 0.0F);
}

TEST(SurfaceImage, WhatIsSetIsWhatIsRead) {
  SurfaceImage image(4, 3, true);
  EXPECT_TRUE(image.wide());
  SurfacePoint surface;
  surface.u = 0.125;
  surface.v = 0.75;
  surface.visibility = 0.5;
  surface.footprint = {6.0, 2.5, 3};
  surface.cascade = 2;
  surface.nextCascade = 0.25;
  for (const double receiver : {0.0, 0.5})
    for (const bool facesLight : {true, false}) {
      surface.receiver = receiver;
      surface.facesLight = facesLight;
      image.set(1, 2, surface);
      const auto read = image.at(1, 2);
      ASSERT_TRUE(read);
      EXPECT_EQ(read->u, surface.u);
      EXPECT_EQ(read->v, surface.v);
      EXPECT_EQ(read->receiver, receiver);
      EXPECT_EQ(read->facesLight, facesLight);
      EXPECT_EQ(read->visibility, surface.visibility);
      EXPECT_EQ(read->footprint, surface.footprint);
      EXPECT_EQ(read->cascade, 2);
      EXPECT_EQ(read->nextCascade, 0.25);
    }
  EXPECT_FALSE(image.shows(2, 1)) << "no other pixel changes";
}

}  // namespace
}  // namespace umbra
