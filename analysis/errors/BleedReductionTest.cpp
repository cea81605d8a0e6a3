#include "analysis/errors/BleedReduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/errors/CompareMap.h"
#include "analysis/probe/TestMaps.h"
#include "filters/core/prefilter/Prefilter.h"

namespace umbra {
namespace {

// A probe of a region of these depths, all of the same weight.
Probe probeOf(const std::vector<double>& depths, double receiver, std::string_view technique) {
  Probe probe;
  for (double depth : depths) probe.region.texels.push_back({0, 0, depth, 1.0 / depths.size()});
  probe.receiver = receiver;
  probe.reference = referenceVisibility(probe.region, receiver);
  const std::shared_ptr<const Technique> made = allTechniques().make(std::string(technique));
  TechniqueResult result;
  result.technique = made;
  result.channels = prefilteredRegion(probe.region, *made, StorageFormat::Double);
  result.visibility = made->visibility({result.channels, probe.region}, receiver);
  probe.techniques.push_back(result);
  return probe;
}

BleedReduction reductionOf(const Probe& probe) {
  return bleedReductionOf(probe, probe.techniques.front()).value();
}

TEST(BleedReduction, BringsTheBoundDownToTheReference) {
  for (double reference : {0.0, 0.2, 0.7})
    for (double bound : {0.75, 0.9, 0.999}) {
      const double a = smallestReduction(bound, reference);
      EXPECT_NEAR((bound - a) / (1.0 - a), reference, 1e-12);
    }
  EXPECT_EQ(smallestReduction(0.3, 0.3), 0.0);
  EXPECT_EQ(smallestReduction(0.3, 0.4), 0.0);
  EXPECT_EQ(smallestReduction(1.0, 1.0), 0.0);
  EXPECT_EQ(smallestReduction(1.0, 0.5), 1.0);
}

// Lauritzen 2008, §3.2: one occluder over a plane does not bleed.
TEST(BleedReduction, TwoPlanesNeedNone) {
  const BleedReduction found = reductionOf(probeOf({0.3, 0.8, 0.8, 0.8}, 0.8, "vsm"));
  EXPECT_NEAR(found.amount, 0.0, 1e-12);
  EXPECT_NEAR(found.darkening, 0.0, 1e-12);
  EXPECT_TRUE(found.removesAll);
}

// Lauritzen 2008, eq. 3.4: A and B fill half of the region each, and both hide C. The reduction
// that C needs also acts on B, on which A's shadow is exact without it: ½ becomes (½ − a)/(1 − a).
TEST(BleedReduction, ThreePlanesPayWithAShadowOnTheSecond) {
  const double a = 0.2, b = 0.5, c = 0.8, dx = b - a, dy = c - b;
  const double bleeding = 0.25 * dx * dx / (0.5 * dx * dx + dx * dy + dy * dy);
  const Probe probe = probeOf({a, b}, c, "vsm");
  EXPECT_NEAR(probe.techniques.front().visibility, bleeding, 1e-12);
  const BleedReduction found = reductionOf(probe);
  EXPECT_NEAR(found.amount, bleeding, 1e-12);
  EXPECT_NEAR(found.darkening, 0.5 - (0.5 - bleeding) / (1.0 - bleeding), 1e-11);
  EXPECT_NEAR(found.meanDarkening, 0.5 * found.darkening, 1e-12);  // B is half of the region
  EXPECT_TRUE(found.removesAll);
}

TEST(BleedReduction, DoesNotDependOnTheAmountThatIsSet) {
  Probe probe = probeOf({0.2, 0.5}, 0.8, "vsm");
  const BleedReduction plain = reductionOf(probe);
  probe.techniques.front().technique = withBleedReduction(*probe.techniques.front().technique, 0.6);
  EXPECT_EQ(reductionOf(probe).amount, plain.amount);
}

// In front of the mean the bound is 1, and stays 1 whatever the amount.
TEST(BleedReduction, CannotRemoveABoundOfOne) {
  const BleedReduction found = reductionOf(probeOf({0.1, 0.9, 0.9, 0.9}, 0.5, "vsm"));
  EXPECT_FALSE(found.removesAll);
  EXPECT_EQ(found.amount, 0.99);
}

TEST(BleedReduction, IsSmallestForEveryTechniqueThatHasIt) {
  const DepthMap map = randomMap(24, 24, 5);
  int needed = 0;
  for (double receiver : {0.45, 0.55, 0.62, 0.85})
    for (int x = 2; x < 22; x += 5) {
      const Probe probe = takeProbe({.map = map,
                                     .read = ReadPoint::atTexel(map, x, 11),
                                     .kernel = {KernelShape::Box, 2},
                                     .receiver = receiver,
                                     .techniques = everyTechnique(map)});
      for (const TechniqueResult& result : probe.techniques) {
        const auto found = bleedReductionOf(probe, result);
        ASSERT_EQ(found.has_value(), largestBleedReduction(*result.technique).has_value());
        if (!found || !found->removesAll) continue;
        const auto visibility = [&](double amount) {
          return withBleedReduction(*result.technique, amount)
              ->visibility({result.channels, probe.region}, receiver);
        };
        EXPECT_LE(visibility(found->amount), probe.reference + 1e-11);
        if (found->amount < 1e-6) continue;
        EXPECT_GT(visibility(found->amount - 1e-6), probe.reference);
        ++needed;
      }
    }
  EXPECT_GT(needed, 20);
}

TEST(BleedReduction, OfAFrameDarkensEveryUmbra) {
  const BoundSample samples[] = {{0.0, 0.0}, {0.4, 0.0}, {1.0, 0.9}, {0.7, 0.7}, {1.0, 1.0}};
  const BleedReduction found = bleedReductionOver(samples, 0.99);
  EXPECT_EQ(found.amount, 0.4);
  EXPECT_TRUE(found.removesAll);
  EXPECT_NEAR(found.darkening, 0.7 - 0.3 / 0.6, 1e-12);
  EXPECT_NEAR(found.meanDarkening, found.darkening / 5.0, 1e-12);
  EXPECT_FALSE(bleedReductionOver(samples, 0.3).removesAll);
  EXPECT_EQ(bleedReductionOver({}, 0.99).amount, 0.0);
}

TEST(BleedReduction, OfAMapIsWhatTheComparisonThenShows) {
  const DepthMap map = randomMap(40, 30, 9);
  const Kernel kernel{KernelShape::Box, 3};
  const auto vsm = allTechniques().make("vsm");
  const auto found = bleedReductionOnMap(map, *vsm, kernel, StorageFormat::Double, 0.95);
  ASSERT_TRUE(found && found->removesAll);
  EXPECT_GT(found->amount, 0.01);
  const std::shared_ptr<const Technique> reduced[] = {withBleedReduction(*vsm, found->amount)};
  const Metrics metrics = compareOnMap(map, reduced, kernel, StorageFormat::Double, 0.95).front();
  EXPECT_NEAR(metrics.umbraBleeding, 0.0, 1e-12);
  EXPECT_NEAR(metrics.darkening, found->meanDarkening, 1e-12);
  EXPECT_NEAR(-std::min(metrics.min, 0.0), found->darkening, 1e-12);
  EXPECT_FALSE(
      bleedReductionOnMap(map, *allTechniques().make("csm"), kernel, StorageFormat::Double, 0.95));
}

}  // namespace
}  // namespace umbra
