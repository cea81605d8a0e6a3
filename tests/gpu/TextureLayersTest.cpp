// How cascades lie in the layers of the baker's textures, and how many layers a technique takes.
#include <random>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/gpu/ChannelBaker.h"
#include "tests/gpu/GpuTest.h"
#include "tests/gpu/Rounding.h"

namespace umbra {
namespace {

using TextureLayers = test::GpuTest;

DepthMap noise(int side, int samples, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  DepthMap map(side, side, samples);
  for (double& depth : map.values()) depth = uniform(random);
  return map;
}

// The contents of the other layers do not matter.
TEST_F(TextureLayers, EveryCascadeIsBakedAsIfItWereAlone) {
  const Kernel kernel{KernelShape::Box, 2};
  for (int samples : {1, 4}) {
    for (const char* id : {"vsm", "power-cdf", "msm", "csm"}) {
      SCOPED_TRACE(id);
      const auto technique = allTechniques().make(id);
      const auto bake = [&](ChannelBaker& baker) {
        baker.encode(*technique, StorageFormat::Half);
        baker.prefilter(kernel);
        baker.buildLevels();
      };
      ChannelBaker all;
      all.prepareDepth(32, 32, 3, samples);
      for (int cascade = 0; cascade < 3; ++cascade)
        all.uploadDepth(noise(32, samples, 7 + cascade), cascade);
      bake(all);
      for (int cascade = 0; cascade < 3; ++cascade) {
        const DepthMap map = noise(32, samples, 7 + cascade);
        ChannelBaker alone;
        alone.uploadDepth(map);
        bake(alone);
        EXPECT_EQ(all.readDepth(cascade), map);
        for (BakeStage stage : {BakeStage::Encoded, BakeStage::Prefiltered})
          EXPECT_EQ(all.read(stage, cascade), alone.read(stage));
        for (int level = 1; level <= 5; ++level)
          EXPECT_EQ(all.readLevel(level, cascade), alone.readLevel(level));
      }
    }
  }
}

// In a seam the same place of the world is read in two maps, whose visibilities are mixed.
TEST_F(TextureLayers, ASeamMixesWhatTwoCascadesSee) {
  const auto technique = allTechniques().make("vsm");
  MapReads reads{{KernelShape::Box, 2}, ReadFilter::Bilinear};
  reads.windows = {Eigen::Vector3f(0.25f, 0.5f, 0.25f), Eigen::Vector3f(0.125f, 0.25f, 0.5f)};
  ChannelBaker both;
  both.prepareDepth(32, 32, 2);
  for (int cascade : {0, 1}) both.uploadDepth(noise(32, 1, 7 + cascade), cascade);
  both.encode(*technique, StorageFormat::Float);
  both.prefilter(reads.kernel);

  const auto evaluate = [&](ChannelBaker& baker, float u, float v, float cascade) {
    gl::Texture surface(GL_RGBA32F, 1, 1), footprint(GL_RGBA32F, 1, 1);
    surface.upload(4, {u, v, 0.55f, 0.0f});
    footprint.upload(4, {0.0f, 0.0f, 1.0f, cascade});
    return baker.evaluate(surface, &footprint, *technique, reads);
  };
  const auto alone = [&](int cascade, float u, float v) {
    ChannelBaker baker;
    baker.uploadDepth(noise(32, 1, 7 + cascade));
    baker.encode(*technique, StorageFormat::Float);
    baker.prefilter(reads.kernel);
    return evaluate(baker, u, v, 0.0f);
  };
  // Powers of two, so that the way from one window to the other rounds nothing: 0.25 + 0.25 · 0.5
  // is 0.125 + 0.5 · 0.5, and 0.5 + 0.25 · 0.75 is 0.25 + 0.5 · 0.875.
  const std::vector<float> first = alone(0, 0.5f, 0.75f), second = alone(1, 0.5f, 0.875f);
  ASSERT_GT(std::abs(first[1] - second[1]), 0.01f) << "two maps that differ";
  for (float weight : {0.0f, 0.25f, 0.75f}) {
    const std::vector<float> mixed = evaluate(both, 0.5f, 0.75f, weight);
    for (int i : {0, 1})
      EXPECT_NEAR(mixed[i], (1.0 - weight) * first[i] + weight * second[i], 4 * test::eps);
  }
  EXPECT_EQ(evaluate(both, 0.5f, 0.875f, 1.0f), second);
}

// M terms are 2M channels, and a shader reads as many layers as its texture array has.
TEST_F(TextureLayers, AFourierSeriesTakesOnlyTheLayersOfItsTerms) {
  const auto technique = allTechniques().make("csm");
  ChannelBaker baker;
  baker.uploadDepth(noise(16, 1, 7));
  for (int count = 1; count <= 16; ++count) {
    parameterNamed(technique->parameters(), "terms", "csm").put(count);
    ASSERT_EQ(technique->channels().size(), std::size_t(2 * count));
    baker.encode(*technique, StorageFormat::Half);
    baker.prefilter({KernelShape::Box, 1});
    EXPECT_EQ(baker.channelMap().layers(), (count + 1) / 2) << count << " terms";
    const std::string text = techniqueSource(*technique, {});
    EXPECT_NE(text.find("#define UMBRA_CHANNELS " + std::to_string(2 * count) + "\n"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace umbra
