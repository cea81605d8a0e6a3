#include "analysis/probe/Probe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/probe/TestMaps.h"
#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

ProbeRequest requestOn(const DepthMap& map, int x, int y, double receiver) {
  return {.map = map,
          .read = ReadPoint::atTexel(map, x, y),
          .kernel = {KernelShape::Gaussian, 3},
          .receiver = receiver,
          .techniques = everyTechnique(map)};
}

// The result must be there.
const TechniqueResult& presentResult(const Probe& probe, std::string_view id) {
  if (const TechniqueResult* result = resultOf(probe, id)) return *result;
  throw std::runtime_error("no such technique");
}

Region regionOf(std::vector<std::pair<double, double>> depthsAndWeights) {
  Region region;
  for (const auto& [depth, weight] : depthsAndWeights)
    region.texels.push_back({0, 0, depth, weight});
  return region;
}

TEST(ReadPoint, FindsEveryTexelAgain) {
  for (int size : {1, 3, 10, 49, 1000, 8191}) {
    const DepthMap map(size, 1);
    for (int x = 0; x < size; ++x)
      EXPECT_EQ(int(std::floor(ReadPoint::atTexel(map, x, 0).u * size)), x);
  }
}

TEST(Probe, SaysWhichTechniquesTheFormatCannotHold) {
  const DepthMap map = randomMap(9, 9, 2);
  ProbeRequest request = requestOn(map, 4, 4, 0.6);
  request.format = StorageFormat::Unorm8;
  const Probe probe = takeProbe(request);
  EXPECT_EQ(probe.techniques.size() + probe.refused.size(), request.techniques.size());
  EXPECT_NO_THROW(presentResult(probe, "vsm"));
  EXPECT_ANY_THROW(presentResult(probe, "esm"));
  ASSERT_FALSE(probe.refused.empty());
  for (const RefusedTechnique& refused : probe.refused)
    EXPECT_EQ(refused.reason, refused.technique->refusal(StorageFormat::Unorm8));
}

TEST(Probe, SaysWhichTechniquesATableOfSumsCannotServe) {
  const DepthMap map = randomMap(9, 9, 2);
  ProbeRequest request = requestOn(map, 4, 4, 0.6);
  request.kernel.shape = KernelShape::Box;
  request.read = {ReadFilter::SummedArea, 0.5, 0.5, {7.0, 7.0, 1}};
  const Probe probe = takeProbe(request);
  EXPECT_NO_THROW(presentResult(probe, "vsm"));
  EXPECT_NO_THROW(presentResult(probe, "esm"));
  EXPECT_ANY_THROW(presentResult(probe, "power-cdf"));
  request.satPrecision = SatPrecision::Integer;
  const Probe integers = takeProbe(request);
  EXPECT_NO_THROW(presentResult(integers, "vsm"));
  EXPECT_ANY_THROW(presentResult(integers, "esm"));
}

TEST(Probe, MeasuresEveryReadAgainstItsOwnRegion) {
  const DepthMap map = randomMap(32, 32, 11);
  for (ReadFilter filter : {ReadFilter::Trilinear, ReadFilter::Anisotropic}) {
    ProbeRequest request = requestOn(map, 0, 0, 0.55);
    request.read = {filter, 0.37, 0.61, {5.5, 2.5, filter == ReadFilter::Trilinear ? 1 : 3}};
    const Probe probe = takeProbe(request);
    const Region region = umbra::regionOf(map, request.kernel, request.read);
    EXPECT_EQ(probe.reference, referenceVisibility(region, 0.55));
    EXPECT_EQ(presentResult(probe, "pcf").error, 0.0);
    EXPECT_NEAR(presentResult(probe, "vsm").channels[0], statisticsOf(region).mean, 1e-12);
  }
}

TEST(ProbeInASeam, MixesTheVisibilitiesOfBothCascades) {
  const DepthMap near = randomMap(16, 16, 12), far = randomMap(16, 16, 13);
  for (double weight : {0.25, 0.75}) {
    ProbeRequest request = requestOn(near, 0, 0, 0.55);
    request.read = {ReadFilter::Bilinear, 0.3, 0.4, {}};
    request.cascade = 1;
    const Probe own = takeProbe(request);
    request.seam.emplace(SeamPart{far, {ReadFilter::Bilinear, 0.6, 0.7, {}}, weight});
    const Probe probe = takeProbe(request);
    ProbeRequest next = requestOn(far, 0, 0, 0.55);
    next.read = request.seam->read;
    const Probe other = takeProbe(next);
    EXPECT_NEAR(probe.reference, std::lerp(own.reference, other.reference, weight), 1e-14);
    EXPECT_EQ(presentResult(probe, "pcf").error, 0.0);
    EXPECT_NEAR(probe.reference, referenceVisibility(probe.region, 0.55), 1e-14);
    const Curves curves = curvesOf(probe, 5), nearCurves = curvesOf(own, 5),
                 farCurves = curvesOf(other, 5);
    for (std::size_t i = 0; i < probe.techniques.size(); ++i) {
      EXPECT_NEAR(probe.techniques[i].visibility,
                  std::lerp(own.techniques[i].visibility, other.techniques[i].visibility, weight),
                  1e-15);
      EXPECT_EQ(probe.techniques[i].channels, (weight > 0.5 ? other : own).techniques[i].channels);
      for (int j = 0; j < 5; ++j)
        EXPECT_NEAR(curves.techniques[i][j],
                    std::lerp(nearCurves.techniques[i][j], farCurves.techniques[i][j], weight),
                    1e-15);
    }
    double total = 0.0, ofNext = 0.0;
    for (const RegionTexel& texel : probe.region.texels) {
      total += texel.weight;
      if (texel.cascade == 2) ofNext += texel.weight;
      EXPECT_TRUE(texel.cascade == 1 || texel.cascade == 2);
    }
    EXPECT_NEAR(total, 1.0, 1e-14);
    EXPECT_NEAR(ofNext, weight, 1e-14);
  }
}

TEST(ProbeInASeam, ReadsTheSamePlaceOfTheNextMap) {
  Cascade from, to;
  from.left = 0.25;
  from.top = 0.5;
  from.side = 0.25;
  to.left = 0.0;
  to.top = 0.25;
  to.side = 0.75;
  const ReadPoint read{ReadFilter::Anisotropic, 0.5, 0.2, {6.0, -3.0, 2}};
  const ReadPoint there = readInCascade(read, from, to, {KernelShape::Box, 2});
  EXPECT_NEAR(from.left + from.side * read.u, to.left + to.side * there.u, 1e-15);
  EXPECT_NEAR(from.top + from.side * read.v, to.top + to.side * there.v, 1e-15);
  EXPECT_NEAR(there.footprint.x, 2.0, 1e-15);
  EXPECT_NEAR(there.footprint.y, -1.0, 1e-15);
  EXPECT_EQ(there.footprint.probes, 2);
  const ReadPoint box{ReadFilter::SummedArea, 0.5, 0.2, {30.0, 6.0, 1}};
  EXPECT_NEAR(readInCascade(box, from, to, {KernelShape::Box, 2}).footprint.x, 10.0, 1e-14);
  EXPECT_EQ(readInCascade(box, from, to, {KernelShape::Box, 2}).footprint.y, 5.0);
}

TEST(Probe, TakesTheRegionOfItsTexel) {
  const DepthMap map = randomMap(20, 12, 1);
  const Probe probe = takeProbe(requestOn(map, 19, 0, 0.6));
  const Region expected = regionAtTexel(map, {KernelShape::Gaussian, 3}, 19, 0);
  ASSERT_EQ(probe.region.texels.size(), expected.texels.size());
  EXPECT_EQ(probe.region.x, 19);
  EXPECT_EQ(probe.region.y, 0);
  for (std::size_t i = 0; i < expected.texels.size(); ++i) {
    EXPECT_EQ(probe.region.texels[i].depth, expected.texels[i].depth);
    EXPECT_EQ(probe.region.texels[i].weight, expected.texels[i].weight);
  }
  EXPECT_EQ(probe.reference, referenceVisibility(expected, 0.6));
}

TEST(Probe, TheFarCornerBelongsToTheLastTexel) {
  const DepthMap map = randomMap(8, 6, 2);
  ProbeRequest request = requestOn(map, 0, 0, 0.5);
  request.read = {ReadFilter::Point, 1.0, 1.0};
  const Probe probe = takeProbe(request);
  EXPECT_EQ(probe.region.x, 7);
  EXPECT_EQ(probe.region.y, 5);
}

TEST(Probe, RefusesATexelOutsideTheMap) {
  const DepthMap map = randomMap(8, 6, 2);
  EXPECT_THROW(takeProbe(requestOn(map, 8, 0, 0.5)), Error);
  EXPECT_THROW(takeProbe(requestOn(map, 0, -1, 0.5)), Error);
}

// Computes the variance from its definition, in long double, independently of the code under test.
// Both sides round at most once per tap and operation: far less than 1e-12 for 49 taps.
TEST(Probe, AgreesWithTheFormulaOfVsm) {
  const DepthMap map = randomMap(32, 32, 3);
  for (int x : {0, 7, 16, 31}) {
    const double receiver = 0.65;
    const Probe probe = takeProbe(requestOn(map, x, 9, receiver));
    long double m1 = 0, m2 = 0, lit = 0;
    for (const RegionTexel& texel : probe.region.texels) {
      m1 += (long double)texel.weight * texel.depth;
      m2 += (long double)texel.weight * texel.depth * texel.depth;
      if (texel.depth >= receiver) lit += texel.weight;
    }
    const long double variance = std::max(m2 - m1 * m1, 1e-6L), d = receiver - m1;
    const double expected = receiver <= m1 ? 1.0 : double(variance / (variance + d * d));
    const TechniqueResult& vsm = presentResult(probe, "vsm");
    EXPECT_NEAR(vsm.visibility, expected, 1e-12);
    EXPECT_NEAR(vsm.error, expected - double(lit), 1e-12);
    EXPECT_NEAR(probe.statistics.variance, double(m2 - m1 * m1), 1e-12);
  }
}

TEST(Probe, AgreesWithThePrefilteredMap) {
  const DepthMap map = randomMap(24, 24, 4);
  const ProbeRequest request = requestOn(map, 2, 21, 0.7);
  const Probe probe = takeProbe(request);
  for (const TechniqueResult& result : probe.techniques) {
    const Image<double> channels =
        prefilteredMap(map, *result.technique, request.kernel, StorageFormat::Double);
    ASSERT_EQ(int(result.channels.size()), channels.channels());
    for (int c = 0; c < channels.channels(); ++c) {
      // Two orders of adding 49 products: n · u · Σ|w v| on either side.
      const double scale = std::max(1.0, std::abs(channels(2, 21, c)));
      EXPECT_NEAR(result.channels[c], channels(2, 21, c), 2 * 49 * 1.2e-16 * scale)
          << result.technique->info().id;
    }
  }
}

TEST(Probe, BilinearReadsMixTheStoredTexels) {
  const DepthMap map = randomMap(16, 16, 5);
  ProbeRequest request = requestOn(map, 0, 0, 0.6);
  request.read = {ReadFilter::Bilinear, 0.41, 0.63};
  request.format = StorageFormat::Half;
  const Probe probe = takeProbe(request);
  EXPECT_EQ(probe.region.texels.size(), 64u);
  for (const TechniqueResult& result : probe.techniques)
    EXPECT_EQ(result.channels,
              readBilinear(map, *result.technique, request.kernel, request.format, 0.41, 0.63));
}

TEST(Probe, PercentageCloserIsTheReference) {
  const DepthMap map = randomMap(16, 16, 6);
  for (double receiver : {0.0, 0.2, 0.5, 0.55, 0.8, 1.0}) {
    const Probe probe = takeProbe(requestOn(map, 8, 8, receiver));
    EXPECT_EQ(presentResult(probe, "pcf").visibility, probe.reference);
    EXPECT_EQ(presentResult(probe, "pcf").error, 0.0);
  }
}

TEST(Histogram, HoldsEveryTexelOnceInTheBinThatHoldsItsDepth) {
  const DepthMap map = randomMap(32, 32, 7);
  const Region region = regionAtTexel(map, {KernelShape::Gaussian, 6}, 11, 20);
  for (int bins : {1, 2, 7, 60, 1000}) {
    const Histogram histogram = histogramOf(region, bins);
    ASSERT_EQ(histogram.edges.size(), std::size_t(bins) + 1);
    ASSERT_EQ(histogram.weights.size(), std::size_t(bins));
    EXPECT_TRUE(std::is_sorted(histogram.edges.begin(), histogram.edges.end()));
    EXPECT_EQ(histogram.edges.front(), statisticsOf(region).min);
    EXPECT_EQ(histogram.edges.back(), statisticsOf(region).max);
    double total = 0.0;
    for (int bin = 0; bin < bins; ++bin) {
      double expected = 0.0;
      for (const RegionTexel& texel : region.texels) {
        const bool last = bin == bins - 1;
        if (texel.depth >= histogram.edges[bin] &&
            (texel.depth < histogram.edges[bin + 1] ||
             (last && texel.depth <= histogram.edges[bin + 1])))
          expected += texel.weight;
      }
      EXPECT_EQ(histogram.weights[bin], expected) << bin << " of " << bins;
      total += histogram.weights[bin];
    }
    EXPECT_NEAR(total, 1.0, 169 * 2.3e-16);
  }
}

TEST(Histogram, PutsADepthOnAnEdgeIntoTheBinThatItBegins) {
  const Region region = regionOf({{0.0, 0.25}, {0.5, 0.25}, {1.0, 0.5}});
  EXPECT_EQ(histogramOf(region, 2).weights, (std::vector<double>{0.25, 0.75}));
}

TEST(Histogram, OfOneDepthIsOneBinWithoutWidth) {
  const Histogram histogram = histogramOf(regionOf({{0.5, 0.5}, {0.5, 0.5}}), 60);
  EXPECT_EQ(histogram.edges, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(histogram.weights, (std::vector<double>{1.0}));
}

TEST(EmpiricalCdf, JoinsEqualDepthsAndEndsAtOne) {
  const EmpiricalCdf cdf =
      empiricalCdfOf(regionOf({{0.8, 0.5}, {0.3, 0.125}, {0.8, 0.125}, {0.5, 0.25}}));
  EXPECT_EQ(cdf.depth, (std::vector<double>{0.3, 0.5, 0.8}));
  EXPECT_EQ(cdf.cumulative, (std::vector<double>{0.125, 0.375, 1.0}));
}

TEST(EmpiricalCdf, ComplementsTheReference) {
  const DepthMap map = randomMap(32, 32, 8);
  const Region region = regionAtTexel(map, {KernelShape::Box, 5}, 4, 4);
  const EmpiricalCdf cdf = empiricalCdfOf(region);
  for (std::size_t i = 0; i < cdf.depth.size(); ++i) {
    // What lies behind depth i, from the reference just behind it.
    const double behind = referenceVisibility(region, std::nextafter(cdf.depth[i], 2.0));
    EXPECT_NEAR(1.0 - cdf.cumulative[i], behind, 121 * 2.3e-16);
  }
}

TEST(Curves, AreWhatAProbeAtEveryDepthGives) {
  const DepthMap map = randomMap(32, 32, 9);
  const ProbeRequest request = requestOn(map, 30, 3, 0.5);
  const Probe probe = takeProbe(request);
  const Curves curves = curvesOf(probe, 101);
  ASSERT_EQ(curves.depth.size(), 101u);
  EXPECT_EQ(curves.depth.front(), 0.0);
  EXPECT_EQ(curves.depth.back(), 1.0);
  ASSERT_EQ(curves.techniques.size(), request.techniques.size());
  for (int i = 0; i < 101; ++i) {
    ProbeRequest there = request;
    there.receiver = curves.depth[i];
    const Probe expected = takeProbe(there);
    EXPECT_NEAR(curves.reference[i], expected.reference, 2 * 49 * 1.2e-16);
    for (std::size_t t = 0; t < curves.techniques.size(); ++t)
      EXPECT_EQ(curves.techniques[t][i], expected.techniques[t].visibility);
  }
}

TEST(Curves, TheReferenceFallsFromOneToZero) {
  const DepthMap map(8, 8, 1, 0.5);
  const Curves curves = curvesOf(takeProbe(requestOn(map, 4, 4, 0.5)), 3);
  EXPECT_EQ(curves.depth, (std::vector<double>{0.0, 0.5, 1.0}));
  EXPECT_EQ(curves.reference, (std::vector<double>{1.0, 1.0, 0.0}));  // equality is lit
}

}  // namespace
}  // namespace umbra
