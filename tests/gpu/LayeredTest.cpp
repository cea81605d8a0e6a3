// The channels of layered techniques on the GPU, and how their splits follow the map from frame to
// frame.
#include <algorithm>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/Lloyd.h"
#include "filters/gpu/ChannelBaker.h"
#include "tests/gpu/FloatSamples.h"
#include "tests/gpu/FrameFixture.h"
#include "tests/gpu/ParityFixture.h"

namespace umbra::test {
namespace {

void set(Technique& technique, std::string_view name, std::string_view text) {
  parameterNamed(technique.parameters(), name, "test").setFromText(text, "test");
}

std::unique_ptr<Technique> lvsmOf(int layers, std::string_view placement = "uniform") {
  std::unique_ptr<Technique> technique = allTechniques().make("lvsm");
  set(*technique, "layers", std::to_string(layers));
  set(*technique, "placement", placement);
  return technique;
}

class Layered : public FrameFixture {
 protected:
  void showLayers(std::unique_ptr<Technique> layered) {
    show(slabAndBall(), "hard");
    technique = std::move(layered);
    renderer->setTechnique(*technique);
    renderer->render();
  }
};

// Lauritzen 2008, §4.1.3: there are two layers in a texture of four 16-bit components.
TEST_F(Layered, StoresTwoLayersInATexture) {
  ChannelBaker baker;
  baker.uploadDepth(testMaps().front().second);
  for (int layers = 2; layers <= 16; ++layers) {
    baker.encode(*lvsmOf(layers), StorageFormat::Unorm16);
    EXPECT_EQ(baker.channelMap().format(), GLenum(GL_RGBA16));
    EXPECT_EQ(baker.channelMap().layers(), (layers + 1) / 2) << layers << " layers";
  }
  baker.encode(*lvsmOf(1), StorageFormat::Unorm16);
  EXPECT_EQ(baker.channelMap().format(), GLenum(GL_RG16));
  EXPECT_EQ(baker.channelMap().layers(), 1);
}

// All layers come from one depth map, which is drawn once, in one pass over its texels.
TEST_F(Layered, EncodesAnyNumberInOnePass) {
  for (int layers : {1, 2, 5, 16}) {
    showLayers(lvsmOf(layers));
    EXPECT_EQ(passes(), "encode prefilter shade view") << layers << " layers";
    EXPECT_EQ(renderer->channels(BakeStage::Encoded).channels(), 2 * layers);
  }
}

// φ is z up to two roundings; a stored value is off by up to one more step of the format.
TEST_F(Layered, OneLayerIsVsm) {
  const std::unique_ptr<Technique> vsm = allTechniques().make("vsm"), one = lvsmOf(1);
  const Kernel kernel{KernelShape::Box, 2};
  for (const auto& [name, map] : testMaps()) {
    for (auto format : {StorageFormat::Unorm16, StorageFormat::Half, StorageFormat::Float}) {
      SCOPED_TRACE(name + " in " + std::string(nameOf(format)));
      const double storage = 2.0 * unitRoundoff(format) + 4.0 * eps;
      ChannelBaker baker;
      baker.uploadDepth(map);
      baker.encode(*vsm, format);
      baker.prefilter(kernel);
      const Image<float> plain = baker.read(BakeStage::Prefiltered);
      Image<float> reads(map.width(), map.height(), 4);
      for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
          reads(x, y, 0) = float((x + 0.5) / map.width());
          reads(x, y, 1) = float((y + 0.5) / map.height());
          reads(x, y, 2) = std::min(1.0f, plain(x, y, 0) + 0.05f * float(x % 7));
        }
      gl::Texture table(GL_RGBA32F, map.width(), map.height());
      table.upload(4, {reads.values().begin(), reads.values().end()});
      const MapReads read{kernel, ReadFilter::Point};
      const std::vector<float> expected = baker.evaluate(table, nullptr, *vsm, read);

      baker.encode(*one, format);
      baker.prefilter(kernel);
      const Image<float> layered = baker.read(BakeStage::Prefiltered);
      ASSERT_EQ(layered.channels(), 2);
      for (std::size_t i = 0; i < plain.values().size(); ++i)
        ASSERT_NEAR(layered.values()[i], plain.values()[i], storage) << "value " << i;
      // Both have the same channels, so that only the formulas are compared.
      baker.upload(BakeStage::Prefiltered, plain);
      const std::vector<float> visibility = baker.evaluate(table, nullptr, *one, read);
      const VisibilityBound plainBound(*vsm, format), layeredBound(*one, format);
      for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
          const std::vector<double> channels{plain(x, y, 0), plain(x, y, 1)};
          const Region region = regionAtTexel(map, kernel, x, y);
          const Fetch fetch{channels, region};
          const std::size_t pixel = 2 * (std::size_t(y) * map.width() + x);
          ASSERT_NEAR(visibility[pixel], expected[pixel],
                      plainBound(fetch, reads(x, y, 2)) + layeredBound(fetch, reads(x, y, 2)))
              << "texel " << x << "," << y;
        }
    }
  }
}

// Without a display all splits are at rest before the frame is drawn, and equal the reference's.
TEST_F(Layered, AFrameHasTheReferencesSplits) {
  showLayers(lvsmOf(4, "lloyd"));
  EXPECT_EQ(passes(), "splits encode prefilter shade view");
  EXPECT_FALSE(renderer->splitsMoving());
  const std::vector<double> splits = renderer->adaptedSplits();
  const LloydResult reference = relax(test::floatSamples(renderer->depthMap()), {.splits = 3});
  ASSERT_EQ(splits.size(), 3u);
  // Means of sums of at most (1024/128)² + 2·128 terms in double.
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(splits[k], reference.splits[k], 2.0 * 320 * unitRoundoff(StorageFormat::Double));
  renderer->render();
  EXPECT_EQ(passes(), "shade view") << "splits at rest cost nothing";

  // Another technique with as many layers uses the same splits.
  technique = allTechniques().make("layered-power-cdf");
  set(*technique, "placement", "lloyd");
  renderer->setTechnique(*technique);
  renderer->render();
  EXPECT_EQ(passes(), "encode prefilter shade view");
  EXPECT_EQ(renderer->adaptedSplits(), splits);
  renderer->setTechnique(*allTechniques().make("vsm"));
  renderer->render();
  EXPECT_TRUE(renderer->adaptedSplits().empty());
}

// Encoding and finding splits both use the depth that the same frame has drawn.
TEST_F(Layered, AFrameWhoseLightMovedUsesItsOwnDepths) {
  settings.map.size = 128;
  show(slabAndBall(), "hard");
  technique = lvsmOf(3, "lloyd");
  renderer->setTechnique(*technique);
  Light light = slabAndBall()->light;
  for (int frame = 0; frame < 4; ++frame) {
    light.position.x() += 0.5;
    renderer->setLight(light);
    renderer->render();
    EXPECT_EQ(passes(), "depth splits encode prefilter shade view");
    const DepthMap map = renderer->depthMap();
    const LloydResult all = relax(test::floatSamples(map), {.splits = 2});
    const std::vector<double> splits = renderer->adaptedSplits();
    for (int k = 0; k < 2; ++k)
      ASSERT_NEAR(splits[k], all.splits[k], 2.0 * 272 * unitRoundoff(StorageFormat::Double));
    technique->setAdaptedSplits(splits);
    const Image<float> channels = renderer->channels(BakeStage::Encoded);
    const Image<double> exact = encodeMap(map, *technique, StorageFormat::Double);
    for (std::size_t i = 0; i < exact.values().size(); ++i)
      ASSERT_NEAR(channels.values()[i], exact.values()[i], 8.0 * eps / 0.01);
  }
}

// In a window the splits come to rest over frames. A copy of the technique that is given the
// frame's splits always encodes as the frame does.
TEST_F(Layered, InAWindowSplitsMoveFromFrameToFrame) {
  settings.map.size = 128;
  settings.kernel = {KernelShape::None, 0};
  show(slabAndBall(), "hard");
  technique = lvsmOf(4, "lloyd");
  renderer->setSplitPace(SplitPace::Gradual);
  renderer->setTechnique(*technique);
  renderer->render();
  EXPECT_EQ(renderer->adaptedSplits(), (std::vector<double>{0.25, 0.5, 0.75}));
  const DepthMap map = renderer->depthMap();
  int frames = 1;
  for (; renderer->splitsMoving() && frames < 1000; ++frames) {
    const Image<float> channels = renderer->channels(BakeStage::Encoded);
    const std::unique_ptr<Technique> copy = technique->clone();
    copy->setAdaptedSplits(renderer->adaptedSplits());
    const Image<double> exact = encodeMap(map, *copy, StorageFormat::Double);
    // p, q and z are rounded, and their differences divided by the width of a layer, which is
    // the overlap at least.
    const double narrowest = 0.01;
    for (std::size_t i = 0; i < exact.values().size(); ++i)
      ASSERT_NEAR(channels.values()[i], exact.values()[i], 8.0 * eps / narrowest)
          << "frame " << frames;
    glFinish();
    renderer->render();
  }
  EXPECT_FALSE(renderer->splitsMoving());
  const std::vector<double> splits = renderer->adaptedSplits();
  const std::vector<WeightedSample> samples = test::floatSamples(map);
  const LloydResult two = relax(samples, {.splits = 3, .movedPerIteration = 2});
  EXPECT_EQ(frames, 1 + two.iterations + two.teleports);
  renderer->render();
  EXPECT_EQ(passes(), "shade view");

  // A light that moves a little starts from the last splits.
  Light light = slabAndBall()->light;
  light.position.x() += 0.1;
  renderer->setLight(light);
  renderer->render();
  EXPECT_EQ(renderer->adaptedSplits(), splits);
  EXPECT_TRUE(renderer->splitsMoving());
  // At the other pace the frame's splits are the reference's.
  renderer->setSplitPace(SplitPace::Converged);
  renderer->render();
  EXPECT_FALSE(renderer->splitsMoving());
  const LloydResult all = relax(test::floatSamples(renderer->depthMap()), {.splits = 3});
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(renderer->adaptedSplits()[k], all.splits[k],
                2.0 * 272 * unitRoundoff(StorageFormat::Double));
}

}  // namespace
}  // namespace umbra::test
