#include "filters/core/settings/StorageFormat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace umbra {
namespace {

constexpr StorageFormat every[] = {StorageFormat::Unorm8, StorageFormat::Unorm16,
                                   StorageFormat::Half, StorageFormat::Float,
                                   StorageFormat::Double};

TEST(StorageFormat, StoringTwiceChangesNothing) {
  std::mt19937 random(51);
  std::uniform_real_distribution<double> uniform(-1.0, 2.0);
  for (StorageFormat format : every) {
    for (int i = 0; i < 1000; ++i) {
      const double once = stored(uniform(random), format, -0.5, 1.5);
      EXPECT_EQ(stored(once, format, -0.5, 1.5), once) << nameOf(format);
    }
  }
}

TEST(StorageFormat, RoundsWithinItsUnit) {
  std::mt19937 random(52);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (StorageFormat format : every) {
    for (int i = 0; i < 1000; ++i) {
      const double value = uniform(random);
      const double allowed = isNormalised(format) ? unitRoundoff(format)
                                                  : unitRoundoff(format) * std::max(value, 1e-4);
      EXPECT_LE(std::abs(stored(value, format) - value), allowed * (1 + 1e-9)) << nameOf(format);
    }
  }
}

TEST(StorageFormat, NormalisedFormatsClampToTheirRange) {
  EXPECT_EQ(stored(-3.0, StorageFormat::Unorm8, -1.0, 1.0), -1.0);
  EXPECT_EQ(stored(3.0, StorageFormat::Unorm16, -1.0, 1.0), 1.0);
  EXPECT_EQ(stored(0.0, StorageFormat::Unorm8), 0.0);
  EXPECT_EQ(stored(1.0, StorageFormat::Unorm8), 1.0);
  EXPECT_EQ(stored(100.4 / 255.0, StorageFormat::Unorm8), 100.0 / 255.0);
  EXPECT_EQ(stored(100.6 / 255.0, StorageFormat::Unorm8), 101.0 / 255.0);
}

// IEEE 754 binary16, by its bits: 1 sign, 5 exponent, 10 fraction.
double halfFrom(int bits) {
  const int exponent = (bits >> 10) & 31, fraction = bits & 1023;
  return exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
}

TEST(StorageFormat, HoldsEveryHalfAndRoundsBetweenThem) {
  for (int bits = 0; bits < (31 << 10); ++bits) {
    const double value = halfFrom(bits);
    ASSERT_EQ(stored(value, StorageFormat::Half), value);
    ASSERT_EQ(stored(-value, StorageFormat::Half), -value);
    if (bits + 1 == 31 << 10) break;
    const double next = halfFrom(bits + 1), middle = (value + next) / 2;
    // Ties go to the even one.
    ASSERT_EQ(stored(middle, StorageFormat::Half), bits % 2 == 0 ? value : next) << bits;
    ASSERT_EQ(stored(std::nextafter(middle, 0.0), StorageFormat::Half), value) << bits;
    ASSERT_EQ(stored(std::nextafter(middle, 1e9), StorageFormat::Half), next) << bits;
  }
}

TEST(StorageFormat, HalfOverflowsWhereItsRoundingSays) {
  EXPECT_EQ(stored(65504.0, StorageFormat::Half), 65504.0);
  EXPECT_EQ(stored(65519.9, StorageFormat::Half), 65504.0);
  EXPECT_TRUE(std::isinf(stored(65520.0, StorageFormat::Half)));
  EXPECT_EQ(stored(-1e9, StorageFormat::Half), -std::numeric_limits<double>::infinity());
}

TEST(StorageFormat, BytesAreThoseOfTheTypes) {
  EXPECT_EQ(bytesOf(StorageFormat::Unorm8), 1);
  EXPECT_EQ(bytesOf(StorageFormat::Unorm16), 2);
  EXPECT_EQ(bytesOf(StorageFormat::Half), 2);
  EXPECT_EQ(bytesOf(StorageFormat::Float), int(sizeof(float)));
  EXPECT_EQ(bytesOf(StorageFormat::Double), int(sizeof(double)));
}

TEST(StorageFormat, FloatIsTheMachines) {
  EXPECT_EQ(stored(0.1, StorageFormat::Float), double(0.1f));
  EXPECT_EQ(stored(0.1, StorageFormat::Double), 0.1);
  EXPECT_EQ(largestOf(StorageFormat::Half), 65504.0);
  EXPECT_EQ(largestOf(StorageFormat::Float), double(std::numeric_limits<float>::max()));
}

}  // namespace
}  // namespace umbra
