// Every technique on the GPU against its double-precision reference, stage by stage: each stage is
// fed with the reference's result of the one before, so that a failure names its stage.
#include "tests/gpu/ParityFixture.h"

namespace umbra {
namespace {

using namespace test;
using Parity = ParityFixture;

// A channel is an elementary function f of depth. GLSL allows exp 3 + 2|x| units in the last
// place, hence |ln f| below (GLSL 4.5, §4.7.1); arguments are rounded too, which the derivative
// carries over. The terms of a channel that keeps to its declared range are as large as the range.
// A chain of eight roundings of any kind bounds the longest formula.
double encodingError(const Technique& technique, double z, std::size_t channel) {
  const std::size_t count = technique.channels().size();
  std::vector<double> here(count), before(count), after(count);
  const double step = 1e-6;
  technique.encode(z, here);
  technique.encode(std::max(z - step, 0.0), before);
  technique.encode(std::min(z + step, 1.0), after);
  const double value = std::abs(here[channel]);
  const double slope = std::abs(after[channel] - before[channel]) / step;
  const double logarithm = value > 0.0 ? std::abs(std::log(value)) : 0.0;
  technique.encode(0.0, before);
  technique.encode(1.0, after);
  const Channel declared = technique.channels()[channel];
  const auto within = [&](double end) { return end >= declared.low && end <= declared.high; };
  const bool keepsToRange = within(before[channel]) && within(after[channel]);
  const double range = keepsToRange ? declared.high - declared.low : 0.0;
  return 8 * eps * (value * (1.0 + logarithm) + slope + range);
}

// Smaller numbers than this may become 0 on a GPU (GLSL 4.5, §4.7.1).
const double smallestNormal = std::ldexp(1.0, -126);

TEST_P(Parity, Encode) {
  inEverySetting({{KernelShape::None, 0}}, [&](const DepthMap& map, const Kernel&) {
    prepare(map);
    const Image<double> exact = encodeMap(map, *technique, StorageFormat::Double);
    const auto tolerance = [&](int x, int y, int c) {
      return storing(exact(x, y, c), layout[c], GetParam().format) +
             encodingError(*technique, map(x, y), c) +
             (std::abs(exact(x, y, c)) < smallestNormal ? smallestNormal : 0.0);
    };
    expectNear(baker->read(BakeStage::Encoded), exact, tolerance);
  });
}

// A sum of w terms of size |x| has an error of at most (w − 1) ε Σ|x|; weights and their products
// add two roundings a term. The two axes follow each other. Extremes compute nothing.
TEST_P(Parity, Prefilter) {
  if (!technique->info().prefilterable) return;
  std::vector<Kernel> kernels = testKernels();
  kernels.push_back({KernelShape::Box, Kernel::largestRadius});
  inEverySetting(kernels, [&](const DepthMap& map, const Kernel& kernel) {
    prepare(map);
    const Image<double> source = encoded(map);
    baker->upload(BakeStage::Encoded, toFloat(source));
    baker->prefilter(kernel);
    const Image<double> exact = reduceMap(source, layout, kernel);
    Image<double> sizes = source;
    for (double& value : sizes.values()) value = std::abs(value);
    sizes = reduceMap(sizes, layout, kernel);
    const double roundings = 2 * (2 * kernel.effectiveRadius() + 1 + 2);
    const auto tolerance = [&](int x, int y, int c) {
      if (layout[c].reduction != Reduction::Mean && !isNormalised(GetParam().format)) return 0.0;
      return storing(exact(x, y, c), layout[c], GetParam().format) +
             roundings * eps * sizes(x, y, c);
    };
    expectNear(baker->read(BakeStage::Prefiltered), exact, tolerance);
  });
}

TEST_P(Parity, Visibility) {
  int sharp = 0, all = 0;  // comparisons to within a hundredth of the whole range
  inEverySetting(testKernels(), [&](const DepthMap& map, const Kernel& kernel) {
    prepare(map);
    Image<double> channels = encoded(map);
    if (technique->info().prefilterable) {
      channels = reduceMap(channels, layout, kernel);
      storeMap(channels, layout, GetParam().format);
      for (double& value : channels.values())
        if (std::abs(value) < smallestNormal) value = 0.0;
      baker->upload(BakeStage::Prefiltered, toFloat(channels));
    }
    Image<float> reads(map.width(), map.height(), 4);
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) {
        reads(x, y, 0) = float((x + 0.5) / map.width());
        reads(x, y, 1) = float((y + 0.5) / map.height());
        reads(x, y, 2) = float(receiverFor(x, y, regionAtTexel(map, kernel, x, y)));
      }
    gl::Texture table(GL_RGBA32F, map.width(), map.height());
    table.upload(4, {reads.values().begin(), reads.values().end()});
    const std::vector<float> gpu =
        baker->evaluate(table, nullptr, *technique, {kernel, ReadFilter::Point});
    const VisibilityBound bound(*technique, GetParam().format);
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const Region region = regionAtTexel(map, kernel, x, y);
        const Fetch fetch{channels.pixel(x, y), region};
        const double receiver = reads(x, y, 2);
        const std::size_t pixel = std::size_t(y) * map.width() + x;
        const double tolerance = bound(fetch, receiver);
        sharp += tolerance < 0.01;
        ++all;
        ASSERT_NEAR(gpu[2 * pixel], technique->visibility(fetch, receiver), tolerance)
            << "texel " << x << "," << y << ", receiver " << receiver;
        // Sums of non-negative weights along both axes.
        ASSERT_NEAR(gpu[2 * pixel + 1], referenceVisibility(region, receiver),
                    2 * (2 * kernel.effectiveRadius() + 1 + 2) * eps)
            << "reference of texel " << x << "," << y << ", receiver " << receiver;
      }
    }
  });
  // Where a receiver is near a depth, or a variance near nothing, rounding decides.
  EXPECT_GT(sharp, all / 3);
}

// The whole way on the GPU: what stands at the light's near or far plane is not in its own shadow,
// however small or large the numbers are that it is encoded into.
TEST_P(Parity, EndsOfTheDepthRange) {
  DepthMap ends(2, 1);
  ends(1, 0) = 1.0;
  gl::Texture table(GL_RGBA32F, 2, 1);
  table.upload(4, {0.25f, 0.5f, 0.0f, 0.0f, 0.75f, 0.5f, 1.0f, 0.0f});
  inEverySetting({{KernelShape::None, 0}}, [&](const DepthMap&, const Kernel& kernel) {
    prepare(ends);
    const std::vector<float> gpu =
        baker->evaluate(table, nullptr, *technique, {kernel, ReadFilter::Point});
    const Image<double> exact = encodeMap(ends, *technique, StorageFormat::Double);
    const VisibilityBound bound(*technique, GetParam().format);
    for (int x : {0, 1}) {
      const Region region = regionAtTexel(ends, kernel, x, 0);
      const std::span<const double> channels = exact.pixel(x, 0);
      std::vector<double> off(channels.size());
      for (std::size_t c = 0; c < off.size(); ++c)
        off[c] =
            storing(channels[c], layout[c], GetParam().format) + encodingError(*technique, x, c);
      const Fetch fetch{channels, region};
      ASSERT_NEAR(gpu[2 * x], technique->visibility(fetch, x), bound(fetch, x, 0, off))
          << "depth " << x;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Parity, testing::ValuesIn(allCases()), nameOfCase);

}  // namespace
}  // namespace umbra
