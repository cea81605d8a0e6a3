// Every technique on the GPU against its double-precision reference, stage by stage: each stage is
// fed with the reference's result of the one before, so that a failure names its stage.
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "filters/core/Prefilter.h"
#include "filters/core/TechniqueCatalogue.h"
#include "filters/gpu/ChannelBaker.h"
#include "tests/gpu/GpuTest.h"
#include "tests/gpu/Rounding.h"

namespace umbra {
namespace {

using test::eps;

// Not square, so that an exchange of the axes shows. Values are floats, as the GPU gets them.
DepthMap mapOf(const std::function<double(int, int)>& depth) {
  DepthMap map(61, 43);
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) map(x, y) = float(depth(x, y));
  return map;
}

// An occluder's edge over a slanted receiver; three planes; noise over the whole range.
std::vector<std::pair<std::string, DepthMap>> testMaps() {
  std::mt19937 random(20080101);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  return {{"edge over a slope",
           mapOf([](int x, int y) { return x + 2 * y < 60 ? 0.25 : 0.5 + 0.004 * x + 0.003 * y; })},
          {"three planes", mapOf([](int x, int y) { return x < 20   ? 0.2
                                                           : y < 17 ? 0.6
                                                                    : 1.0; })},
          {"noise", mapOf([&](int, int) { return uniform(random); })}};
}

std::vector<Kernel> testKernels() {
  std::vector<Kernel> kernels{{KernelShape::None, 0}};
  for (KernelShape shape : {KernelShape::Box, KernelShape::Gaussian})
    for (int radius : {1, 3, 8}) kernels.push_back({shape, radius});
  kernels.push_back({KernelShape::Box, Kernel::largestRadius});
  return kernels;
}

// Largest error of storing a value of magnitude `value` once.
double storing(double value, const Channel& channel, StorageFormat format) {
  if (isNormalised(format))  // u is of the fraction; mapping it costs a few float roundings
    return (channel.high - channel.low) * (unitRoundoff(format) + 4 * eps);
  const double smallestStep = format == StorageFormat::Half ? std::ldexp(1.0, -24) : 0.0;
  return unitRoundoff(format) * std::abs(value) + smallestStep / 2;
}

struct Case {
  std::string technique;
  StorageFormat format;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.technique << " in " << nameOf(test.format);
}

std::vector<Case> allCases() {
  std::vector<Case> cases;
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* technique : catalogue.all())
    for (auto format :
         {StorageFormat::Unorm8, StorageFormat::Unorm16, StorageFormat::Half, StorageFormat::Float})
      if (technique->refusal(format).empty())
        cases.push_back({std::string(technique->info().id), format});
  return cases;
}

std::string nameOfCase(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.technique + "_" + std::string(nameOf(info.param.format));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class Parity : public test::GpuTest, public testing::WithParamInterface<Case> {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    technique = allTechniques().make(GetParam().technique);
    technique->limitTo(GetParam().format);
    layout = technique->channels();
    baker.emplace();
  }
  void TearDown() override {
    baker.reset();
    GpuTest::TearDown();
  }

  void prepare(const DepthMap& map) {
    technique->adapt(map);
    baker->uploadDepth(map);
    baker->encode(*technique, GetParam().format);
  }

  // The reference's channels before the prefilter, stored.
  Image<double> encoded(const DepthMap& map) const {
    return encodeMap(map, *technique, GetParam().format);
  }

  std::unique_ptr<Technique> technique;
  std::vector<Channel> layout;
  std::optional<ChannelBaker> baker;
};

Image<float> toFloat(const Image<double>& image) {
  Image<float> result(image.width(), image.height(), image.channels());
  std::copy(image.values().begin(), image.values().end(), result.values().begin());
  return result;
}

// The first texel that is out of tolerance is enough to say what is wrong.
template <class Tolerance>
void expectNear(const Image<float>& gpu, const Image<double>& cpu, const Tolerance& tolerance) {
  ASSERT_EQ(gpu.width(), cpu.width());
  ASSERT_EQ(gpu.height(), cpu.height());
  for (int y = 0; y < cpu.height(); ++y)
    for (int x = 0; x < cpu.width(); ++x)
      for (int c = 0; c < cpu.channels(); ++c)
        ASSERT_NEAR(gpu(x, y, c), cpu(x, y, c), tolerance(x, y, c))
            << "channel " << c << " of texel " << x << "," << y;
}

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

TEST_P(Parity, Encode) {
  for (const auto& [name, map] : testMaps()) {
    SCOPED_TRACE(name);
    prepare(map);
    const Image<double> exact = encodeMap(map, *technique, StorageFormat::Double);
    const auto tolerance = [&, &depths = map](int x, int y, int c) {
      return storing(exact(x, y, c), layout[c], GetParam().format) +
             encodingError(*technique, depths(x, y), c);
    };
    expectNear(baker->read(BakeStage::Encoded), exact, tolerance);
    if (HasFatalFailure()) return;
  }
}

// A sum of w terms of size |x| has an error of at most (w − 1) ε Σ|x|; weights and their products
// add two roundings a term. The two axes follow each other. Extremes compute nothing.
TEST_P(Parity, Prefilter) {
  if (!technique->info().prefilterable) return;
  for (const auto& [name, map] : testMaps()) {
    for (const Kernel& kernel : testKernels()) {
      SCOPED_TRACE(name + ", " + describe(kernel));
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
      if (HasFatalFailure()) return;
    }
  }
}

// Receivers at every kind of place: behind, before and exactly at what the texel saw.
double receiverFor(int x, int y, const Region& region) {
  const RegionStatistics statistics = statisticsOf(region);
  switch ((x + 3 * y) % 5) {
    case 0:
      return region.nearestDepth;
    case 1:
      return float(std::clamp(statistics.mean + 0.01, 0.0, 1.0));
    case 2:
      return float(0.5 * (statistics.mean + statistics.max));
    case 3:
      return float(0.5 * (statistics.min + statistics.mean));
    default:
      return float(((x * 37 + y * 101) % 97) / 96.0);
  }
}

TEST_P(Parity, Visibility) {
  for (const auto& [name, map] : testMaps()) {
    for (const Kernel& kernel : testKernels()) {
      if (kernel.radius > 8) continue;
      SCOPED_TRACE(name + ", " + describe(kernel));
      prepare(map);
      Image<double> channels = encoded(map);
      if (technique->info().prefilterable) {
        channels = reduceMap(channels, layout, kernel);
        storeMap(channels, layout, GetParam().format);
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
      for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
          const Region region = regionAtTexel(map, kernel, x, y);
          const Fetch fetch{channels.pixel(x, y), region};
          const double receiver = reads(x, y, 2);
          const std::size_t pixel = std::size_t(y) * map.width() + x;
          ASSERT_NEAR(gpu[2 * pixel], technique->visibility(fetch, receiver),
                      test::visibilityError(*technique, GetParam().format, fetch, receiver))
              << "texel " << x << "," << y << ", receiver " << receiver;
          // Sums of non-negative weights along both axes.
          ASSERT_NEAR(gpu[2 * pixel + 1], referenceVisibility(region, receiver),
                      2 * (2 * kernel.effectiveRadius() + 1 + 2) * eps)
              << "reference of texel " << x << "," << y << ", receiver " << receiver;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Parity, testing::ValuesIn(allCases()), nameOfCase);

}  // namespace
}  // namespace umbra
