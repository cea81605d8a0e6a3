// Shared by the comparisons of the GPU with the reference: maps, kernels, techniques in formats,
// and the error of storing.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <string>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/gpu/ChannelBaker.h"
#include "tests/gpu/GpuTest.h"
#include "tests/gpu/Rounding.h"
#include "tests/properties/Draws.h"

namespace umbra::test {

// The map is not square, so that an exchange of the axes shows. Values are floats, as on the GPU.
inline DepthMap mapOf(const std::function<double(int, int)>& depth) {
  DepthMap map(61, 43);
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) map(x, y) = float(depth(x, y));
  return map;
}

// An occluder's edge over a slanted receiver; three planes; noise over the whole range.
inline std::vector<std::pair<std::string, DepthMap>> testMaps() {
  std::mt19937 random(20080101);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  return {{"edge over a slope",
           mapOf([](int x, int y) { return x + 2 * y < 60 ? 0.25 : 0.5 + 0.004 * x + 0.003 * y; })},
          {"three planes", mapOf([](int x, int y) { return x < 20   ? 0.2
                                                           : y < 17 ? 0.6
                                                                    : 1.0; })},
          {"noise", mapOf([&](int, int) { return uniform(random); })}};
}

inline std::vector<Kernel> testKernels() {
  std::vector<Kernel> kernels{{KernelShape::None, 0}};
  for (KernelShape shape : {KernelShape::Box, KernelShape::Gaussian})
    for (int radius : {1, 3, 8}) kernels.push_back({shape, radius});
  return kernels;
}

// Largest error of storing a value of magnitude `value` once.
inline double storing(double value, const Channel& channel, StorageFormat format) {
  if (isNormalised(format))  // u is of the fraction; mapping it costs a few float roundings
    return (channel.high - channel.low) * (unitRoundoff(format) + 4 * eps);
  const double smallestStep = format == StorageFormat::Half ? std::ldexp(1.0, -24) : 0.0;
  return unitRoundoff(format) * std::abs(value) + smallestStep / 2;
}

struct Case {
  std::string technique;
  StorageFormat format;
};

inline void PrintTo(const Case& test, std::ostream* out) {
  *out << test.technique << " in " << nameOf(test.format);
}

inline std::vector<Case> allCases() {
  std::vector<Case> cases;
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* technique : catalogue.all())
    for (auto format :
         {StorageFormat::Unorm8, StorageFormat::Unorm16, StorageFormat::Half, StorageFormat::Float})
      if (technique->refusal(format).empty())
        cases.push_back({std::string(technique->info().id), format});
  return cases;
}

inline std::string nameOfCase(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.technique + "_" + std::string(nameOf(info.param.format));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class ParityFixture : public GpuTest, public testing::WithParamInterface<Case> {
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

  // Compares `compare(map, kernel)` for the technique at its defaults, at both ends of each of its
  // parameters and with drawn ones, in turn on each map and with each kernel, all pairs of them.
  template <class Compare>
  void inEverySetting(const std::vector<Kernel>& kernels, const Compare& compare) {
    const auto maps = testMaps();
    draws::fromSeed(20080227, [&] {
      settings = draws::settingsOf(GetParam().technique, int(maps.size() * kernels.size()));
    });
    ASSERT_EQ(std::lcm(maps.size(), kernels.size()), maps.size() * kernels.size());
    for (std::size_t i = 0; i < settings.size(); ++i) {
      technique = settings[i]->clone();
      technique->limitTo(GetParam().format);
      layout = technique->channels();
      const auto& [name, map] = maps[i % maps.size()];
      const Kernel& kernel = kernels[i % kernels.size()];
      SCOPED_TRACE(draws::described(*technique) + ", " + name + ", " + describe(kernel));
      compare(map, kernel);
      if (HasFatalFailure()) return;
    }
  }

  void prepare(const DepthMap& map) {
    technique->adapt(map);
    baker->uploadDepth(map);
    baker->encode(*technique, GetParam().format);
  }

  // The reference's channels before the prefilter, as stored.
  Image<double> encoded(const DepthMap& map) const {
    return encodeMap(map, *technique, GetParam().format);
  }

  std::vector<std::unique_ptr<Technique>> settings;
  std::unique_ptr<Technique> technique;
  std::vector<Channel> layout;
  std::optional<ChannelBaker> baker;
};

inline Image<float> toFloat(const Image<double>& image) {
  Image<float> result(image.width(), image.height(), image.channels());
  std::copy(image.values().begin(), image.values().end(), result.values().begin());
  return result;
}

// The first texel that is out of tolerance is enough to show what is wrong.
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

// Receivers at every kind of place: behind, before and exactly at the texel's depth.
inline double receiverFor(int x, int y, const Region& region) {
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

}  // namespace umbra::test
