// What the values of a depth file say about how it is meant.
#include "datasets/maps/DepthGuesses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "datasets/maps/ExrFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

constexpr float boundless = std::numeric_limits<float>::infinity();

class DepthGuessing : public testing::Test {
 protected:
  fs::path filed(const std::vector<float>& values) const {
    Image<float> image(int(values.size()), 1);
    std::copy(values.begin(), values.end(), image.values().begin());
    writeExr(folder_ / "g.exr", {{"Z", image}}, {});
    return folder_ / "g.exr";
  }
  RawDepths raw(const std::vector<float>& values) const { return readRawDepths(filed(values), ""); }
  std::vector<DepthGuess> guesses(const std::vector<float>& values,
                                  const DepthImport& present = {}) const {
    return depthGuesses(raw(values), present);
  }

  const TemporaryFolder folder_;
};

// `count` values from `low` to `high` at equal distances.
std::vector<float> ramp(float low, float high, int count) {
  std::vector<float> values;
  for (int i = 0; i < count; ++i)
    values.push_back(std::lerp(low, high, float(i) / float(count - 1)));
  return values;
}

std::vector<float> with(std::vector<float> values, float more, int times) {
  values.insert(values.end(), std::size_t(times), more);
  return values;
}

TEST_F(DepthGuessing, CountsWhatTheFileHolds) {
  const RawDepths raw =
      this->raw({0.5F, 2.0F, 2.0F, 8.0F, std::nanf(""), boundless, boundless, -boundless, 1e10F});
  EXPECT_EQ(raw.finite, 5U);
  EXPECT_EQ(raw.notNumbers, 1U);
  EXPECT_EQ(raw.plusInfinite, 2U);
  EXPECT_EQ(raw.minusInfinite, 1U);
  EXPECT_EQ(raw.lowest.value, 0.5);
  EXPECT_FALSE(raw.lowest.apart);
  EXPECT_EQ(raw.highest.value, 1e10);
  EXPECT_EQ(raw.highest.next, 8.0);
  EXPECT_EQ(raw.highest.texels, 1U);
  EXPECT_TRUE(raw.highest.apart);
  // The histogram spans the rest: four values from 0.5 to 8.
  EXPECT_EQ(raw.low, 0.5);
  EXPECT_EQ(raw.high, 8.0);
  EXPECT_EQ(std::accumulate(raw.counts.begin(), raw.counts.end(), std::size_t(0)), 4U);
  EXPECT_EQ(raw.counts.front(), 1U);
  EXPECT_EQ(raw.counts.back(), 1U);
  EXPECT_EQ(raw.counts[std::size_t((2.0 - 0.5) / 7.5 * RawDepths::bins)], 2U);
  EXPECT_EQ(raw.channels, std::vector<std::string>{"Z"});
}

TEST_F(DepthGuessing, AnOrdinaryMapGivesNone) {
  EXPECT_TRUE(guesses(ramp(0.2F, 0.8F, 50)).empty());
  EXPECT_TRUE(guesses(with(ramp(0.2F, 0.8F, 50), 1.0F, 20)).empty());
  EXPECT_TRUE(guesses({0.5F}).empty());
}

TEST_F(DepthGuessing, ABackgroundAndARangeMakeTheFileReadable) {
  const std::vector<float> values = with(ramp(0.7F, 5.0F, 50), 1e10F, 7);
  const fs::path file = filed(values);
  EXPECT_THROW(readDepth(file, {}), Error);
  const auto first = guesses(values);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0].reason, "7 texels hold 1e+10, and no other value exceeds 5.");
  EXPECT_EQ(first[0].import.miss, (DepthMiss{DepthMiss::Kind::Value, 1e10}));
  const auto second = guesses(values, first[0].import);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0].reason, "Values lie from 0.7 to 5, beyond the range.");
  EXPECT_EQ(second[0].import.atZero, 0.7);  // not 0.699999988
  const DepthFile read = readDepth(file, second[0].import);
  EXPECT_EQ(read.map(0, 0), 0.0);
  EXPECT_EQ(read.map(49, 0), 1.0);
  EXPECT_EQ(read.map(56, 0), 1.0);
  EXPECT_TRUE(guesses(values, second[0].import).empty());
}

TEST_F(DepthGuessing, ARangeThatFallsStaysFalling) {
  DepthImport falling;
  falling.atZero = 1.0;
  falling.atOne = 0.0;
  const auto found = guesses(ramp(0.5F, 8.0F, 50), falling);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].import.atZero, 8.0);
  EXPECT_EQ(found[0].import.atOne, 0.5);
}

TEST_F(DepthGuessing, ValuesThatAreNoNumbersAreMarks) {
  const auto infinite = guesses(with(ramp(0.2F, 0.8F, 50), boundless, 3));
  ASSERT_EQ(infinite.size(), 1U);
  EXPECT_EQ(infinite[0].import.miss.value, double(boundless));
  const auto none = guesses(with(ramp(0.2F, 0.8F, 50), std::nanf(""), 1));
  ASSERT_EQ(none.size(), 1U);
  EXPECT_EQ(none[0].reason, "1 texel holds no number.");
  EXPECT_TRUE(std::isnan(none[0].import.miss.value));
  // One value alone can be named: two kinds need the bounds.
  const auto both = guesses(with(with(ramp(0.2F, 0.8F, 50), boundless, 3), -1.0F, 2));
  ASSERT_EQ(both.size(), 3U);
  EXPECT_EQ(both[1].import.miss.value, -1.0);
  EXPECT_EQ(both[2].import.miss.kind, DepthMiss::Kind::Clamp);
}

TEST_F(DepthGuessing, ZeroBelowDistancesIsAMark) {
  const auto found = guesses(with(ramp(2.0F, 8.0F, 50), 0.0F, 10));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].import.miss, (DepthMiss{DepthMiss::Kind::Value, 0.0}));
  EXPECT_EQ(found[1].import.atZero, 2.0);
  // Distances that begin at 0 are none.
  for (const DepthGuess& guess : guesses(with(ramp(0.0F, 8.0F, 1000), 0.0F, 30)))
    EXPECT_EQ(guess.import.miss, DepthMiss());
}

// Distances from 1 to 40 behind planes at 0.1 and 100, by the definitions of the projections.
TEST_F(DepthGuessing, ProjectionsAreToldByTheirCrowds) {
  for (const char* text : {"perspective:0.1,100", "reversed:0.1,100"}) {
    const DepthProjection projection = projectionFrom(text, "test");
    std::vector<float> values;
    for (float distance : ramp(1.0F, 40.0F, 60))
      values.push_back(float(projection.window(distance)));
    const auto found = guesses(with(values, projection.isReversed() ? 0.0F : 1.0F, 9));
    ASSERT_EQ(found.size(), 1U) << text;
    EXPECT_EQ(found[0].import.projection.kind, projection.kind);
    EXPECT_TRUE(found[0].needsPlanes);
    DepthImport given = found[0].import;
    given.projection.near = 0.1;
    given.projection.far = 100.0;
    EXPECT_TRUE(guesses(values, given).empty());
  }
}

TEST_F(DepthGuessing, AnEvenMapWhoseBackgroundIsZeroIsTurnedRound) {
  const auto found = guesses(with(ramp(0.2F, 0.8F, 50), 0.0F, 10));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].import.atZero, 1.0);
  EXPECT_EQ(found[0].import.atOne, 0.0);
  EXPECT_TRUE(guesses(with(with(ramp(0.2F, 0.8F, 50), 0.0F, 10), 1.0F, 1)).empty());
}

}  // namespace
}  // namespace umbra
