#include "analysis/errors/ErrorDecomposition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "analysis/errors/BleedReduction.h"
#include "analysis/probe/TestMaps.h"
#include "analysis/probe/TestProbes.h"

namespace umbra {
namespace {

double part(const ErrorParts& parts, ErrorPart which) {
  return parts[std::size_t(which)];
}

double sum(const ErrorParts& parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

Probe probeWith(const std::vector<double>& depths, double receiver, const Technique& technique) {
  Probe probe = probeOfDepths(depths, receiver);
  for (const auto& each : decompositionTechniques(technique.clone())) addResult(probe, each);
  return probe;
}

TEST(ErrorDecomposition, DistantOccludersBleed) {
  const auto vsm = allTechniques().make("vsm");
  const Probe probe = probeWith({0.2, 0.5}, 0.8, *vsm);
  const double bound = probe.techniques[0].visibility;
  const ErrorParts parts = decomposed(bound, 0.0, probe);
  EXPECT_EQ(part(parts, ErrorPart::Bleeding), bound);
  EXPECT_EQ(sum(parts), bound);
}

TEST(ErrorDecomposition, TouchingOccludersLeak) {
  const auto vsm = allTechniques().make("vsm");
  const Probe probe = probeWith({0.498, 0.4985}, 0.5, *vsm);
  const double bound = probe.techniques[0].visibility;
  EXPECT_GT(bound, 0.1);
  const ErrorParts parts = decomposed(bound, 0.0, probe);
  EXPECT_EQ(part(parts, ErrorPart::ContactLeak), bound);
  EXPECT_EQ(part(parts, ErrorPart::Bleeding), 0.0);
  // One leaf that happens to touch the receiver does not turn bleeding from afar into a leak at a
  // contact.
  const Probe leaf = probeWith({0.1, 0.15, 0.2, 0.498}, 0.5, *vsm);
  EXPECT_GT(part(decomposed(0.2, 0.0, leaf), ErrorPart::Bleeding), 0.0);
}

TEST(ErrorDecomposition, ReductionIsTakenFromTheBound) {
  const auto reduced = withBleedReduction(*allTechniques().make("vsm"), 0.3);
  // There are two planes with half of the region each. The bound is ½ and exact; reduced it is (½ −
  // 0.3)/0.7.
  const Probe probe = probeWith({0.2, 0.8}, 0.8, *reduced);
  ASSERT_EQ(probe.techniques.size(), 2u);
  const double v = probe.techniques[0].visibility;
  EXPECT_NEAR(v, 0.2 / 0.7, 1e-12);
  const ErrorParts parts = decomposed(v, 0.5, probe);
  EXPECT_NEAR(part(parts, ErrorPart::Reduction), 0.2 / 0.7 - 0.5, 1e-12);
  EXPECT_NEAR(sum(parts), v - 0.5, 1e-15);
  EXPECT_NEAR(part(parts, ErrorPart::Bleeding) + part(parts, ErrorPart::OverDarkening), 0.0, 1e-12);
}

TEST(ErrorDecomposition, WhatIsStoredDiffersByItsPrecision) {
  const auto vsm = allTechniques().make("vsm");
  Probe stored = probeOfDepths({0.61, 0.615, 0.62}, 0.63);
  addResult(stored, vsm->clone(), StorageFormat::Half);
  const Probe exact = probeWith({0.61, 0.615, 0.62}, 0.63, *vsm);
  const double v = stored.techniques[0].visibility;
  EXPECT_GT(std::abs(v - exact.techniques[0].visibility), 0.05);
  EXPECT_EQ(part(decomposed(v, 0.0, exact), ErrorPart::Precision),
            v - exact.techniques[0].visibility);
}

TEST(ErrorDecomposition, PowerCdfOverDarkens) {
  const auto power = allTechniques().make("power-cdf");
  const Probe probe =
      probeWith({0.2, 0.5, 0.8}, 0.8, *power);  // the receiver at the region's own maximum is dark
  const ErrorParts parts = decomposed(probe.techniques[0].visibility, probe.reference, probe);
  EXPECT_NEAR(part(parts, ErrorPart::OverDarkening), -1.0 / 3.0, 1e-12);
}

// A frame of receivers at a depth, each looking at a texel of its own.
struct Frame {
  DepthMap map = randomMap(24, 16, 4);
  SurfaceImage surfaces{24, 16};
  Image<float> reference{24, 16};
  Kernel kernel{KernelShape::Box, 2};
  std::vector<std::shared_ptr<const Technique>> techniques;

  explicit Frame(std::shared_ptr<const Technique> technique)
      : techniques(decompositionTechniques(technique)) {
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 24; ++x) {
        const Probe probe = probeAt(x, y, StorageFormat::Half);
        SurfacePoint surface{.u = 0.5, .v = 0.0, .receiver = 0.62F};
        surface.visibility = probe.techniques[0].visibility;
        if (x % 5 != 0) surfaces.set(x, y, surface);  // every fifth column shows no surface
        reference(x, y) = float(probe.reference);
      }
  }
  Probe probeAt(int x, int y, StorageFormat format) const {
    return takeProbe({.map = map,
                      .read = ReadPoint::atTexel(map, x, y),
                      .kernel = kernel,
                      .format = format,
                      .receiver = 0.62F,
                      .techniques = techniques});
  }
  ErrorDecomposition taken(const DecompositionSettings& settings = {}) const {
    ErrorDecomposition result = emptyDecomposition(24, 16);
    for (int y = 15; y >= 0; --y)
      decomposeRow(
          surfaces, reference, y, techniques.size() > 1,
          [&](int px, int py) { return probeAt(px, py, StorageFormat::Double); }, settings, result);
    return result;
  }
};

// Four differences of numbers up to 1, in double.
TEST(ErrorDecomposition, FramesAddUpPixelByPixelAndOverall) {
  for (const char* id : {"vsm", "esm", "power-cdf", "csm", "pcf"}) {
    std::shared_ptr<const Technique> technique = allTechniques().make(id);
    if (std::string_view(id) == "vsm") technique = withBleedReduction(*technique, 0.2);
    const Frame frame(technique);
    const ErrorDecomposition taken = frame.taken();
    double total = 0.0;
    std::size_t pixels = 0;
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 24; ++x) {
        EXPECT_EQ(taken.receives(x, y), x % 5 == 0 ? 0 : 1);
        const double error =
            x % 5 == 0 ? 0.0 : double(frame.surfaces.visibility(x, y)) - frame.reference(x, y);
        double parts = 0.0;
        for (double value : taken.parts.pixel(x, y)) parts += value;
        EXPECT_NEAR(parts, error, 4e-16) << id << " " << x << "," << y;
        total += error;
        pixels += x % 5 != 0;
      }
    const ErrorSums sums = sumsOf(taken);
    EXPECT_EQ(sums.pixels, pixels);
    EXPECT_NEAR(sums.error, total / double(pixels), 1e-14) << id;
  }
}

TEST(ErrorDecomposition, SmallErrorsAreCountedApart) {
  const Frame frame(allTechniques().make("vsm"));
  const ErrorSums coarse = sumsOf(frame.taken({.resolution = 2.0}));
  EXPECT_EQ(coarse.means[std::size_t(ErrorPart::Small)], coarse.error);
  const ErrorSums fine = sumsOf(frame.taken({.resolution = 0.0}));
  EXPECT_EQ(fine.means[std::size_t(ErrorPart::Small)], 0.0);
  EXPECT_GT(fine.means[std::size_t(ErrorPart::Bleeding)], 0.01);
  EXPECT_NEAR(fine.error, coarse.error, 1e-14);
}

TEST(ErrorDecomposition, ASelectionCountsItsOwnPixels) {
  const Frame frame(allTechniques().make("vsm"));
  const ErrorDecomposition taken = frame.taken();
  const LassoPoint box[] = {{1.0, 2.0}, {4.0, 2.0}, {4.0, 5.0}, {1.0, 5.0}};
  const Image<std::uint8_t> mask = lassoMask(box, 24, 16);
  double expected = 0.0;
  for (int y = 2; y < 5; ++y)
    for (int x = 1; x < 4; ++x)
      expected += double(frame.surfaces.visibility(x, y)) - double(frame.reference(x, y));
  const ErrorSums sums = sumsOf(taken, &mask);
  EXPECT_EQ(sums.pixels, 9u);
  EXPECT_NEAR(sums.error, expected / 9.0, 1e-15);
}

// There are three pixels in a row; the last one receives no shadow.
ErrorDecomposition threePixels() {
  ErrorDecomposition taken = emptyDecomposition(3, 1);
  taken.receives(0, 0) = taken.receives(1, 0) = 1;
  const auto set = [&](int x, ErrorPart which, double value) {
    taken.parts(x, 0, int(which)) = value;
  };
  set(0, ErrorPart::Bleeding, 0.4);
  set(0, ErrorPart::Reduction, -0.35);
  set(1, ErrorPart::OverDarkening, -0.3);
  set(1, ErrorPart::Reduction, -0.1);
  return taken;
}

TEST(ErrorDecomposition, TheWorstPixelIsTheOneOfThePart) {
  const ErrorDecomposition taken = threePixels();
  EXPECT_NEAR(errorAt(taken, 0, 0, std::nullopt), 0.05, 1e-15);
  EXPECT_EQ(errorAt(taken, 1, 0, ErrorPart::OverDarkening), -0.3);
  const auto worst = [&](std::optional<ErrorPart> which, const Image<std::uint8_t>* in = nullptr) {
    const auto pixel = worstPixel(taken, which, in);
    return pixel ? pixel->x : -1;
  };
  EXPECT_EQ(worst(std::nullopt), 1) << "−0.4 against +0.05";
  EXPECT_EQ(worst(ErrorPart::Bleeding), 0);
  EXPECT_EQ(worst(ErrorPart::Reduction), 0);
  EXPECT_EQ(worst(ErrorPart::Precision), -1) << "none has any";
  Image<std::uint8_t> second(3, 1);
  second(1, 0) = 1;
  EXPECT_EQ(worst(ErrorPart::Reduction, &second), 1);
  EXPECT_EQ(worst(ErrorPart::Bleeding, &second), -1);
}

TEST(ErrorDecomposition, ColoursSpanNearlyEveryError) {
  EXPECT_EQ(colourRange(threePixels(), std::nullopt), 0.5);
  EXPECT_EQ(colourRange(threePixels(), ErrorPart::Precision), 0.01) << "nothing to be seen";
  ErrorDecomposition many = emptyDecomposition(1000, 1);
  for (int x = 0; x < 1000; ++x)
    many.parts(x, 0, int(ErrorPart::Bleeding)) = x < 5 ? 0.9 : 0.03;  // five stray pixels
  EXPECT_EQ(colourRange(many, ErrorPart::Bleeding), 0.05);
  for (int x = 0; x < 100; ++x) many.parts(x, 0, int(ErrorPart::Bleeding)) = -0.9;
  EXPECT_EQ(colourRange(many, ErrorPart::Bleeding), 1.0);
}

TEST(ErrorDecomposition, ALassoHoldsTheCentresInside) {
  const LassoPoint triangle[] = {{0.0, 0.0}, {8.0, 0.0}, {0.0, 8.0}};
  const Image<std::uint8_t> mask = lassoMask(triangle, 10, 10);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 10; ++x) EXPECT_EQ(mask(x, y), x + y + 1 < 8 ? 1 : 0) << x << "," << y;
  // The even–odd rule leaves what is circled twice out.
  const LassoPoint twice[] = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {6, 0}, {6, 6}, {0, 6}};
  EXPECT_EQ(lassoMask(twice, 8, 8), Image<std::uint8_t>(8, 8));
  const LassoPoint beyond[] = {{-9.0, -9.0}, {50.0, -9.0}, {50.0, 50.0}, {-9.0, 50.0}};
  EXPECT_EQ(lassoMask(beyond, 4, 3), Image<std::uint8_t>(4, 3, 1, 1));
  EXPECT_EQ(lassoMask({}, 3, 3), Image<std::uint8_t>(3, 3));
}

}  // namespace
}  // namespace umbra
