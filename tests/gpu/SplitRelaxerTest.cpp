#include "filters/gpu/SplitRelaxer.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "datasets/scenes/SceneCatalogue.h"
#include "filters/core/settings/StorageFormat.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/gpu/ShadowRenderer.h"
#include "tests/gpu/FloatSamples.h"
#include "tests/gpu/GpuTest.h"

namespace umbra::test {
namespace {

constexpr int manyFrames = 10000;

class SplitRelaxerTest : public GpuTest {
 protected:
  // The map's depths as the GPU has them.
  static gl::Texture upload(const DepthMap& map) {
    gl::Texture texture(GL_R32F, map.width(), map.height(), 1);
    texture.upload(1, std::vector<float>(map.values().begin(), map.values().end()));
    return texture;
  }

  // Draws frames until nothing moves, as a window does.
  static int settle(SplitRelaxer& relaxer, const gl::Texture& depth, int count) {
    int frames = 0;
    do {
      relaxer.advance(depth, count, SplitPace::Gradual);
      glFinish();  // the sums that a frame asked for are there at the next one
    } while (++frames < manyFrames && relaxer.moving());
    return frames;
  }
};

DepthMap planes(int width, int height, const std::vector<double>& depths) {
  DepthMap map(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      map(x, y) = float(depths[std::size_t(x / 3 + 2 * (y / 5)) % depths.size()]);
  return map;
}

// Groups of depths with gaps between them, and a slope.
DepthMap randomMap(unsigned seed, int width, int height) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  DepthMap map(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double heap = 0.05 + 0.3 * std::floor(3.0 * uniform(random));
      map(x, y) = float(heap + 0.1 * uniform(random) + 0.1 * x / width);
    }
  return map;
}

// A mean is a quotient of two sums in double of at most this many terms along any path (those of
// one invocation, of which there are up to 128 along either axis, then two levels of 128). The
// terms w·u are exact: floats multiply to 48 digits. |u| ≤ 1.
double roundingOf(const DepthMap& map) {
  const double along = std::max(4.0, std::ceil(map.width() / 128.0));
  const double down = std::max(4.0, std::ceil(map.height() / 128.0));
  return 2.0 * (along * down + 2 * 128) * unitRoundoff(StorageFormat::Double);
}

void expectEqual(const LloydResult& gpu, const LloydResult& cpu, double rounding) {
  EXPECT_EQ(gpu.iterations, cpu.iterations);
  EXPECT_EQ(gpu.teleports, cpu.teleports);
  ASSERT_EQ(gpu.splits.size(), cpu.splits.size());
  for (std::size_t k = 0; k < cpu.splits.size(); ++k)
    EXPECT_NEAR(gpu.splits[k], cpu.splits[k], rounding) << "split " << k;
  ASSERT_EQ(gpu.cost.size(), cpu.cost.size());
  // The cost is made of three sums, each at most 1 in size for one unit of weight, and of two
  // splits.
  for (std::size_t i = 0; i < cpu.cost.size(); ++i)
    EXPECT_NEAR(gpu.cost[i], cpu.cost[i], 4.0 * rounding) << "iteration " << i;
}

TEST_F(SplitRelaxerTest, ConvergesToTheReferencesSplits) {
  std::vector<DepthMap> maps{planes(64, 48, {0.2, 0.55, 0.7}), planes(33, 130, {0.9, 0.95}),
                             planes(2, 2, {0.5, 0.5}), randomMap(9, 2, 300)};
  for (unsigned seed = 0; seed < 4; ++seed) maps.push_back(randomMap(seed, 160 + int(seed), 96));
  SplitRelaxer relaxer;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const gl::Texture depth = upload(maps[i]);
    const std::vector<WeightedSample> samples = test::floatSamples(maps[i]);
    for (int count : {1, 2, 3, 7, 15}) {
      SCOPED_TRACE("map " + std::to_string(i) + ", splits " + std::to_string(count));
      relaxer.mapChanged();
      relaxer.advance(depth, count, SplitPace::Converged);
      EXPECT_FALSE(relaxer.moving());
      expectEqual(relaxer.result(), relax(samples, {.splits = count}), roundingOf(maps[i]));
    }
  }
}

TEST_F(SplitRelaxerTest, ConvergesToTheReferencesSplitsOfAScene) {
  const auto scene = std::make_shared<const Scene>(makeScene("tree-bench"));
  ShadowRenderer renderer(*window);
  FrameSettings settings;
  settings.map.size = 512;
  renderer.setScene(scene);
  renderer.setLight(scene->light);
  renderer.setCamera(scene->camera);
  renderer.setFrame(settings);
  renderer.setTechnique(*allTechniques().make("hard"));
  renderer.render();
  const DepthMap map = renderer.depthMap();
  const gl::Texture depth = upload(map);
  const std::vector<WeightedSample> samples = test::floatSamples(map);
  SplitRelaxer relaxer;
  for (int count : {3, 7}) {
    relaxer.advance(depth, count, SplitPace::Converged);
    expectEqual(relaxer.result(), relax(samples, {.splits = count}), roundingOf(map));
  }
}

TEST_F(SplitRelaxerTest, ClampsWeightsAsTheReferenceDoes) {
  const DepthMap map = randomMap(5, 70, 50);
  const WeightClamp clamp{.low = 0.001, .high = 0.01};
  SplitRelaxer relaxer(clamp);
  relaxer.advance(upload(map), 4, SplitPace::Converged);
  expectEqual(relaxer.result(), relax(test::floatSamples(map, clamp), {.splits = 4}),
              roundingOf(map));
}

TEST_F(SplitRelaxerTest, CostNeverRises) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const DepthMap map = randomMap(seed, 120, 90);
    const gl::Texture depth = upload(map);
    for (SplitPace pace : {SplitPace::Converged, SplitPace::Gradual}) {
      SplitRelaxer relaxer;
      if (pace == SplitPace::Gradual)
        settle(relaxer, depth, 6);
      else
        relaxer.advance(depth, 6, pace);
      const std::vector<double> cost = relaxer.result().cost;
      ASSERT_GT(cost.size(), 2u);
      for (std::size_t i = 1; i < cost.size(); ++i)
        EXPECT_LE(cost[i], cost[i - 1] + 8.0 * roundingOf(map));
      EXPECT_LT(cost.back(), cost.front());
    }
  }
}

// The paper's two splits a frame: sums that a frame asks for move splits in a later frame.
TEST_F(SplitRelaxerTest, NoFrameWaitsForItsOwnSums) {
  const DepthMap map = randomMap(1, 120, 90);
  const gl::Texture depth = upload(map);
  SplitRelaxer relaxer;
  const std::vector<double> uniform{0.2, 0.4, 0.6, 0.8};
  relaxer.advance(depth, 4, SplitPace::Gradual);
  EXPECT_EQ(relaxer.splits(), uniform);
  EXPECT_TRUE(relaxer.moving());
  glFinish();
  EXPECT_TRUE(relaxer.advance(depth, 4, SplitPace::Gradual));
  EXPECT_NE(relaxer.splits()[0], uniform[0]);
  EXPECT_NE(relaxer.splits()[1], uniform[1]);
  EXPECT_EQ(relaxer.splits()[2], uniform[2]);
  EXPECT_EQ(relaxer.splits()[3], uniform[3]);
}

TEST_F(SplitRelaxerTest, TwoSplitsAFrameEndWhereNothingMovesEither) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const DepthMap map = randomMap(seed, 120, 90);
    const gl::Texture depth = upload(map);
    const std::vector<WeightedSample> samples = test::floatSamples(map);
    SplitRelaxer relaxer;
    const int frames = settle(relaxer, depth, 5);
    const LloydResult two = relax(samples, {.splits = 5, .movedPerIteration = 2});
    expectEqual(relaxer.result(), two, roundingOf(map));
    EXPECT_EQ(frames, 1 + two.iterations + two.teleports);  // a teleport asks for sums once more
    // Splits at rest at one pace are at rest at the other.
    const LloydResult again = relax(samples, {.splits = 5, .start = two.splits});
    EXPECT_EQ(again.iterations, 1);
    EXPECT_NEAR(again.cost.back(), relaxer.result().cost.back(), 4.0 * roundingOf(map));
    EXPECT_FALSE(relaxer.advance(depth, 5, SplitPace::Gradual));
    EXPECT_FALSE(relaxer.moving());
  }
}

TEST_F(SplitRelaxerTest, GoesOnFromTheLastSplitsWhenTheMapChanges) {
  const gl::Texture depth = upload(randomMap(2, 120, 90));
  SplitRelaxer relaxer;
  settle(relaxer, depth, 5);
  const std::vector<double> first = relaxer.splits();

  relaxer.mapChanged();                         // the new map has equal depths
  EXPECT_EQ(settle(relaxer, depth, 5), 1 + 3);  // five splits, two in each frame
  EXPECT_EQ(relaxer.splits(), first);

  const DepthMap other = randomMap(3, 100, 110);
  const gl::Texture otherDepth = upload(other);
  relaxer.mapChanged();
  relaxer.advance(otherDepth, 5, SplitPace::Gradual);
  EXPECT_EQ(relaxer.splits(), first);
  settle(relaxer, otherDepth, 5);
  const LloydResult again =
      relax(test::floatSamples(other), {.splits = 5, .start = relaxer.splits()});
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(again.splits[k], relaxer.splits()[k], roundingOf(other));
}

// While a light is dragged every frame has another map: the sums of the last map move splits
// nevertheless.
TEST_F(SplitRelaxerTest, MovesWhileTheMapChangesInEveryFrame) {
  SplitRelaxer relaxer;
  std::vector<double> last;
  for (unsigned frame = 0; frame < 8; ++frame) {
    const gl::Texture depth = upload(randomMap(frame, 60, 60));
    relaxer.mapChanged();
    relaxer.advance(depth, 4, SplitPace::Gradual);
    glFinish();
    if (frame > 0) {
      EXPECT_NE(relaxer.splits(), last) << "frame " << frame;
    }
    last = relaxer.splits();
    EXPECT_TRUE(std::is_sorted(last.begin(), last.end()));
  }
}

TEST_F(SplitRelaxerTest, StartsUniformWithAnotherCount) {
  const gl::Texture depth = upload(randomMap(2, 120, 90));
  SplitRelaxer relaxer;
  settle(relaxer, depth, 5);
  relaxer.advance(depth, 3, SplitPace::Gradual);
  EXPECT_EQ(relaxer.splits(), (std::vector<double>{0.25, 0.5, 0.75}));
}

TEST_F(SplitRelaxerTest, TeleportsSplitsWithoutSamples) {
  const DepthMap map = planes(64, 48, {0.86, 0.9, 0.94});  // no sample is near to 0.25
  SplitRelaxer relaxer;
  relaxer.advance(upload(map), 3, SplitPace::Converged);
  EXPECT_GT(relaxer.result().teleports, 0);
  const auto cost = relaxer.result().cost;
  EXPECT_LT(cost.back(), cost.front());
  SplitRelaxer gradual;
  settle(gradual, upload(map), 3);
  EXPECT_GT(gradual.result().teleports, 0);
  EXPECT_GT(gradual.splits().front(), 0.8);
}

TEST_F(SplitRelaxerTest, RestsAtOnceOnAFlatMap) {
  const gl::Texture depth = upload(DepthMap(16, 16, 1, 0.5));
  SplitRelaxer relaxer;
  EXPECT_EQ(settle(relaxer, depth, 3), 2);
  EXPECT_EQ(relaxer.splits(), (std::vector<double>{0.25, 0.5, 0.75}));
}

}  // namespace
}  // namespace umbra::test
