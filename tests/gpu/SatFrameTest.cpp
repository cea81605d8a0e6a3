// Summed-area tables and multisampled maps in whole frames: what is baked when, how wide boxes are,
// and what is refused.
#include <cmath>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Error.h"
#include "filters/core/technique/Composition.h"
#include "filters/gpu/vtkUmbraDepthPass.h"
#include "tests/gpu/FrameFixture.h"

namespace umbra {
namespace {

class SatFrame : public test::FrameFixture {
 protected:
  void SetUp() override {
    FrameFixture::SetUp();
    settings.map.size = 128;
    settings.kernel = {KernelShape::Box, 2};
    settings.read.filter = ReadFilter::SummedArea;
    settings.read.satSize = SatSize::Fixed;
  }

  // The surface at a point of the ground that nothing hides.
  SurfacePoint ground() {
    const Eigen::Vector2i pixel = pixelOf(renderer->camera(), {-2, 0, 2});
    const auto point = renderer->surfaceAt(pixel.x(), pixel.y());
    EXPECT_TRUE(point.has_value());
    return point.value_or(SurfacePoint{});
  }
};

TEST_F(SatFrame, OnlyThePrecisionBuildsAnotherTable) {
  show(test::slabOverGround(), "vsm");
  EXPECT_EQ(passes(), "depth encode prefilter sums shade view");
  settings.kernel.radius = 5;
  settings.read.satSize = SatSize::Distance;
  settings.read.satDistance = 30.0;
  showAgain();
  EXPECT_EQ(passes(), "shade view");
  settings.read.satPrecision = SatPrecision::Integer;
  showAgain();
  EXPECT_EQ(passes(), "sums shade view");
  settings.read.filter = ReadFilter::Bilinear;
  showAgain();
  EXPECT_EQ(passes(), "prefilter shade view");
}

TEST_F(SatFrame, ATechniqueOfRawTexelsHasNoTable) {
  show(test::slabOverGround(), "pcf");
  EXPECT_EQ(passes(), "depth encode prefilter shade view");
}

TEST_F(SatFrame, TheBoxFollowsItsRule) {
  show(test::slabOverGround(), "vsm");
  EXPECT_EQ(ground().footprint, (Footprint{5, 5, 1}));

  settings.read.satSize = SatSize::Distance;
  settings.read.satDistance = 50.0;
  showAgain();
  const SurfacePoint point = ground();
  const double distance = (point.world - renderer->camera().position).norm();
  ASSERT_LT(distance, 50.0);
  // World positions are read from a depth buffer whose steps are a thousandth of this at most.
  EXPECT_NEAR(point.footprint.x, 5 * 50.0 / distance, 1e-3 * point.footprint.x);
  EXPECT_EQ(point.footprint.x, point.footprint.y);
  settings.read.satDistance = 0.5 * distance;
  showAgain();
  EXPECT_EQ(ground().footprint, (Footprint{5, 5, 1})) << "never narrower than the kernel";
  settings.read.satDistance = 1e5;
  showAgain();
  EXPECT_EQ(ground().footprint.x, double(ReadSettings::largestSatWidth));
}

// A pixel's derivatives are differences within its group of 2 × 2 pixels.
TEST_F(SatFrame, AFootprintIsWhatAPixelCovers) {
  settings.map.size = 2048;
  settings.kernel = {KernelShape::None, 0};
  settings.read.satSize = SatSize::Footprint;
  show(test::slabOverGround(), "vsm");
  const Image<float> surfaces = renderer->surfaces().coded();
  Eigen::Vector2i pixel = pixelOf(renderer->camera(), {-2, 0, 2});
  const int x = pixel.x() / 2 * 2, y = pixel.y() / 2 * 2;  // top left of its group
  const auto point = renderer->surfaceAt(x, y);
  ASSERT_TRUE(point.has_value());
  for (int axis : {0, 1}) {
    double low = 1e300, high = 0.0;  // range over both rows and both columns
    for (int i : {0, 1}) {
      for (int j : {0, 1}) {
        const double along = surfaces(x + 1, y + j, axis) - surfaces(x, y + j, axis);
        const double down = surfaces(x + i, y + 1, axis) - surfaces(x + i, y, axis);
        const double covered = (std::abs(along) + std::abs(down)) * settings.map.size;
        low = std::min(low, covered);
        high = std::max(high, covered);
      }
    }
    const double box = axis == 0 ? point->footprint.x : point->footprint.y;
    ASSERT_GT(low, 1.5) << "too fine a picture for this test";
    // Coordinates up to 1 are rounded in a chain of sixteen operations.
    const double rounding = 4 * 16 * 6e-8 * settings.map.size;
    EXPECT_GE(box, low - rounding);
    EXPECT_LE(box, high + rounding);
  }
}

TEST_F(SatFrame, WhatCannotBeIsRefusedWithTheReason) {
  const auto refusal = [&](const char* id) {
    try {
      show(test::slabOverGround(), id);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const auto& [id, shape] :
       {std::pair("power-cdf", KernelShape::Box), std::pair("vsm", KernelShape::Gaussian)}) {
    settings.kernel.shape = shape;
    const std::string reason = whyImpossible(settings, *allTechniques().make(id));
    EXPECT_NE(reason, "");
    EXPECT_EQ(refusal(id), reason);
  }
  settings.read.filter = ReadFilter::Bilinear;
  EXPECT_EQ(refusal("vsm"), "");
  settings.read.filter = ReadFilter::SummedArea;  // there is nothing to bake
  renderer->setFrame(settings);
  EXPECT_THROW(renderer->render(), Error);
}

TEST_F(SatFrame, SamplesAreCountedAndComeWithTheMap) {
  for (int asked : {1, 2, 4, 8}) {
    settings.map.samples = asked;
    show(test::slabAndBall(), "vsm");
    EXPECT_EQ(renderer->samples(), vtkUmbraDepthPass::SamplesGiven(asked));
    EXPECT_EQ(renderer->depthMap().channels(), renderer->samples());
    // Values up to 1: a sum of the samples' and a division after each one's own encoding.
    const Image<double> exact = encodeMap(renderer->depthMap(), *technique, StorageFormat::Double);
    const Image<float> channels = renderer->channels(BakeStage::Encoded);
    for (std::size_t i = 0; i < exact.values().size(); ++i)
      ASSERT_NEAR(channels.values()[i], exact.values()[i],
                  (renderer->samples() + 4) * unitRoundoff(StorageFormat::Float));
  }
}

}  // namespace
}  // namespace umbra
