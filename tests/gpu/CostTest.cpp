// Frames that are drawn to be measured are the frames that anybody sees, and what moves in them is
// what is meant to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/gpu/ChannelBaker.h"
#include "filters/gpu/bench/FrameCosts.h"
#include "filters/gpu/bench/MovingScene.h"
#include "tests/gpu/FrameFixture.h"

namespace umbra {
namespace {

class CostTest : public test::FrameFixture {
 protected:
  static BenchView viewOf(std::shared_ptr<const Scene> scene) {
    return {scene, scene->light, scene->camera, 64, 48};
  }
};

TEST_F(CostTest, BothClocksTimeTheSamePasses) {
  show(test::slabOverGround(), "vsm");
  const std::string names = passes();
  EXPECT_EQ(names, "depth encode prefilter shade view");
  for (PassClock clock : {PassClock::Processor, PassClock::Gpu}) {
    renderer->setPassClock(clock);
    renderer->forgetBake();
    renderer->render();
    EXPECT_EQ(passes(), names);
    for (const PassTime& time : renderer->passTimes()) {
      EXPECT_TRUE(std::isfinite(time.milliseconds)) << time.pass;
      EXPECT_GE(time.milliseconds, 0.0) << time.pass;
    }
  }
}

// The clock is that of the frame, whatever is set afterwards.
TEST_F(CostTest, AFrameKeepsTheClockThatItWasDrawnOn) {
  show(test::slabOverGround(), "vsm");
  renderer->setPassClock(PassClock::Processor);
  renderer->forgetBake();
  renderer->render();
  const std::vector<PassTime> before = renderer->passTimes();
  renderer->setPassClock(PassClock::Gpu);
  const std::vector<PassTime> after = renderer->passTimes();
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(before[i].milliseconds, after[i].milliseconds);
}

TEST_F(CostTest, AForgottenBakeIsDoneAgainWithTheSameResult) {
  show(test::slabOverGround(), "vsm");
  const Image<float> channels = renderer->channels(BakeStage::Prefiltered);
  showAgain();
  EXPECT_EQ(passes(), "shade view");
  renderer->forgetBake();
  renderer->render();
  EXPECT_EQ(passes(), "depth encode prefilter shade view");
  EXPECT_TRUE(
      std::ranges::equal(renderer->channels(BakeStage::Prefiltered).values(), channels.values()));
}

TEST_F(CostTest, MeasuringLeavesTheFrameAsItWas) {
  show(test::slabOverGround(), "vsm");
  const Image<std::uint8_t> picture = renderer->colour();
  const FrameCosts cost = costOfFrames(*renderer);
  EXPECT_GT(cost.bakeMs, 0.0);
  EXPECT_GT(cost.shadeMs, 0.0);
  EXPECT_TRUE(std::ranges::equal(renderer->colour().values(), picture.values()));
}

TEST_F(CostTest, BytesUsedAreThoseOfTheTexturesByTexel) {
  settings.map.size = 64;
  settings.map.cascades.count = 3;
  const auto csm = allTechniques().make("csm");
  EXPECT_EQ(bytesUsedPerTexel(settings, *csm) * 3 * 64 * 64, double(textureBytes(settings, *csm)));
}

TEST_F(CostTest, TheLightsMotionBakesEverything) {
  settings.map.size = 64;
  TechniqueFrames frames(viewOf(test::slabOverGround()));
  EXPECT_EQ(frames.clock(), fittingClock());
  for (const char* id : {"vsm", "lvsm"}) {
    const auto one = allTechniques().make(id);
    frames.show(settings, *one);
    EXPECT_GT(frames.draw(Motion::Light), 0.0);
    EXPECT_GT(frames.draw(Motion::Camera), 0.0);
    std::string names;
    for (const PassTime& time : frames.drawPasses()) names += time.pass + " ";
    EXPECT_EQ(names, "depth encode prefilter shade view ") << id;
  }
}

TEST_F(CostTest, SplitsFollowTheLightAndRestForTheCamera) {
  settings.map.size = 64;
  TechniqueFrames frames(viewOf(test::slabAndBall()));
  const auto lvsm = allTechniques().make("lvsm");
  parameterNamed(lvsm->parameters(), "placement", "lvsm").set(std::string("lloyd"), "lvsm");
  frames.show(settings, *lvsm);
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(frames.draw(Motion::Camera), 0.0);
    std::string names;
    for (const PassTime& time : frames.drawPasses()) names += time.pass + " ";
    EXPECT_EQ(names, "depth splits encode prefilter shade view ");
  }
}

TEST_F(CostTest, BaselinesAreDrawnOnEitherClock) {
  for (Baseline baseline : {Baseline::NoShadow, Baseline::VtkShadowMapPass})
    for (CostClock clock : {CostClock::Processor, CostClock::Gpu}) {
      VtkFrames frames(viewOf(test::slabOverGround()), baseline, 64, clock);
      EXPECT_EQ(frames.clock(), clock);
      for (Motion motion : {Motion::Light, Motion::Camera}) EXPECT_GT(frames.draw(motion), 0.0);
    }
}

}  // namespace
}  // namespace umbra
