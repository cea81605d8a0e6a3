// Where a depth lies half-way between two values that a format holds, the GPU stores what the
// reference stores: a driver's own rounding may go either way.
#include <cmath>
#include <vector>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/gpu/ChannelBaker.h"
#include "tests/gpu/GpuTest.h"

namespace umbra {
namespace {

// Depths at, just below and just above a tie, as floats, which is what the GPU gets.
void addAround(double tie, std::vector<float>& depths) {
  const float at = float(tie);
  for (const float depth : {std::nextafter(at, 0.0f), at, std::nextafter(at, 1.0f)})
    depths.push_back(depth);
}

int stepsOf(StorageFormat format) {
  return format == StorageFormat::Unorm8 ? 255 : 65535;
}

// Every tie of 255 steps; of 65535, every 59th and so about 1,100.
std::vector<float> tiesOf(StorageFormat format) {
  std::vector<float> depths{0.0f, 1.0f};
  if (format == StorageFormat::Half) {
    // Half-way between neighbours at every exponent, subnormal ones among them.
    for (int exponent = -24; exponent < 0; ++exponent)
      for (int step = 0; step < 1024; step += 23) {
        const double spacing = std::ldexp(1.0, std::max(exponent, -14) - 10);
        const double tie = std::ldexp(1.0, exponent) + (step + 0.5) * spacing;
        if (tie < 1.0) addAround(tie, depths);
      }
    return depths;
  }
  const int steps = stepsOf(format);
  for (int step = 0; step < steps; step += format == StorageFormat::Unorm8 ? 1 : 59)
    addAround((step + 0.5) / steps, depths);
  return depths;
}

class StoredTies : public test::GpuTest, public testing::WithParamInterface<StorageFormat> {};

TEST_P(StoredTies, AreRoundedAsTheReferenceDoes) {
  const std::vector<float> depths = tiesOf(GetParam());
  constexpr int columns = 64;
  DepthMap map(columns, int((depths.size() + columns - 1) / columns), 1, 1.0);
  std::copy(depths.begin(), depths.end(), map.values().begin());
  const auto technique = allTechniques().make("power-cdf");  // its channels are the depth itself
  technique->adapt(map);
  ChannelBaker baker;
  baker.uploadDepth(map);
  baker.encode(*technique, GetParam());
  const Image<float> gpu = baker.read(BakeStage::Encoded);
  const Image<double> cpu = encodeMap(map, *technique, GetParam());
  // What is stored is a whole number of steps; reading it back divides by 255 or 65535, which may
  // round in the last place of a float.
  const double steps = stepsOf(GetParam());
  const auto stored = [&](double value) {
    return isNormalised(GetParam()) ? value * steps : value;
  };
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      for (int c = 0; c < cpu.channels(); ++c) {
        const double expected = stored(cpu(x, y, c)), found = stored(gpu(x, y, c));
        ASSERT_NEAR(found, expected, isNormalised(GetParam()) ? 0.01 : 0.0)
            << "channel " << c << " of depth " << std::hexfloat << map(x, y);
      }
}

INSTANTIATE_TEST_SUITE_P(Formats, StoredTies,
                         testing::Values(StorageFormat::Unorm8, StorageFormat::Unorm16,
                                         StorageFormat::Half),
                         [](const auto& drawn) { return std::string(nameOf(drawn.param)); });

}  // namespace
}  // namespace umbra
