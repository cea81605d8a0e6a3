#include "analysis/plots/Precision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/probe/TestMaps.h"

namespace umbra {
namespace {

TechniquePrecision precisionFor(const DepthMap& map, std::string_view id) {
  std::shared_ptr<Technique> technique = allTechniques().make(id);
  technique->adapt(map);
  return precisionOf({.map = map,
                      .read = ReadPoint::atTexel(map, 9, 8),
                      .kernel = {KernelShape::Box, 2},
                      .receiver = 0.62},
                     technique);
}

const FormatPrecision& in(const TechniquePrecision& precision, StorageFormat format) {
  for (const FormatPrecision& entry : precision.formats)
    if (entry.format == format) return entry;
  throw std::runtime_error("no such format");
}

// Every texel is rounded, then the mean of them: two roundings of values up to 1.
TEST(Precision, ErrorsOfMomentsAreTwoRoundings) {
  const DepthMap map = randomMap(20, 20, 11);
  const TechniquePrecision precision = precisionFor(map, "vsm");
  ASSERT_EQ(precision.formats.size(), 4u);
  for (const FormatPrecision& entry : precision.formats) {
    ASSERT_EQ(entry.errors.size(), 2u) << nameOf(entry.format);
    // A normalised format rounds to the nearest of 2^b − 1 steps, to half a step.
    const double rounding = entry.format == StorageFormat::Unorm8    ? 0.5 / 255.0
                            : entry.format == StorageFormat::Unorm16 ? 0.5 / 65535.0
                                                                     : unitRoundoff(entry.format);
    double largest = 0.0;
    for (double error : entry.errors) {
      EXPECT_LE(error, 2.0 * rounding + 1e-15) << nameOf(entry.format);
      largest = std::max(largest, error);
    }
    EXPECT_GT(largest, 1e-3 * rounding);  // noise is not stored exactly
  }
  EXPECT_GT(in(precision, StorageFormat::Unorm8).visibilityError,
            in(precision, StorageFormat::Float).visibilityError);
}

TEST(Precision, SaysWhatAFormatRefusesAndLimits) {
  const DepthMap map = randomMap(20, 20, 11);
  const TechniquePrecision esm = precisionFor(map, "esm");
  EXPECT_FALSE(in(esm, StorageFormat::Unorm8).refusal.empty());
  EXPECT_TRUE(in(esm, StorageFormat::Unorm8).errors.empty());
  EXPECT_FALSE(in(esm, StorageFormat::Half).limits.empty());  // e^40 is beyond 65504
  EXPECT_TRUE(in(esm, StorageFormat::Float).limits.empty());
}

TEST(Precision, PlotsTheLogarithmsOfWhatIsNotExact) {
  const DepthMap map = randomMap(20, 20, 11);
  const TechniquePrecision precision = precisionFor(map, "vsm");
  const Plot plot = precisionPlot(precision);
  ASSERT_EQ(plot.series.size(), 4u);
  const PlotSeries& half = plot.series[2];
  EXPECT_EQ(half.name, "half");
  ASSERT_EQ(half.x.size(), 3u);
  EXPECT_NEAR(std::pow(10.0, half.y[0]), in(precision, StorageFormat::Half).errors[0], 1e-15);
  EXPECT_EQ(half.x.back(), 3.0);
  EXPECT_EQ(plot.markers.back().label, "visibility");

  const DepthMap flat(8, 8, 1, 0.5);  // stored exactly in floats
  const TechniquePrecision exact = precisionOf({.map = flat,
                                                .read = ReadPoint::atTexel(flat, 4, 4),
                                                .kernel = {KernelShape::None},
                                                .receiver = 0.5},
                                               allTechniques().make("vsm"));
  EXPECT_TRUE(precisionPlot(exact).series[3].x.empty());
}

}  // namespace
}  // namespace umbra
