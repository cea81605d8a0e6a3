// The papers' closed forms, over drawn depths and shares.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/properties/Draws.h"

namespace umbra {
namespace {

constexpr double minVariance = 1e-6;  // the default of every technique that has one

void set(Technique& technique, std::string_view name, const ParameterValue& value) {
  parameterNamed(technique.parameters(), name, "test").set(value, "test");
}

// Lauritzen 2008, §3.2: the bound is the share p of the farther of two depths. Distances and shares
// are such that the smallest variance has no effect: p(1 − p)·Δ² > min-variance·c² for EVSM's c =
// 40, with the warp's Δ.
RC_GTEST_PROP(TwoDepths, AreExactInEveryWarp, ()) {
  const double near = draws::between(0.0, 0.7);
  const double far = draws::between(near + 0.2, 1.0);
  const double p = draws::between(0.05, 0.95);
  const Region region = draws::regionOf({near, far}, {1.0 - p, p});
  for (const char* id : {"vsm", "evsm2", "evsm4"})
    RC_ASSERT(std::abs(draws::visibilityOf(*draws::make(id), region, far) - p) < 1e-12);
}

// In layers, the clamp may bring the depths as near to each other as the receiver is to its layer's
// near end; that is 2δ beyond the blended zone: 0.02² · 0.0475 > min-variance.
RC_GTEST_PROP(TwoDepths, AreExactInLayers, ()) {
  const auto lvsm = draws::make("lvsm");
  const int layers = *rc::gen::inRange(1, 9);
  set(*lvsm, "layers", layers);
  const double near = draws::between(0.0, 0.7);
  const double far = draws::between(near + 0.2, 1.0);
  for (int k = 1; k < layers; ++k) RC_PRE(std::abs(far - double(k) / layers) > 0.0101);
  const double p = draws::between(0.05, 0.95);
  const Region region = draws::regionOf({near, far}, {1.0 - p, p});
  RC_ASSERT(std::abs(draws::visibilityOf(*lvsm, region, far) - p) < 1e-9);
}

// Lauritzen 2008, eq. 3.4: two occluders A and B over C, where the reference is 0.
RC_GTEST_PROP(ThreePlanes, BleedByTheirClosedForm, ()) {
  const double a = draws::between(0.0, 0.5), b = draws::between(a + 0.01, 0.8);
  const double c = draws::between(b, 1.0);
  const double dx = b - a, dy = c - b;
  const double expected = 0.25 * dx * dx / (0.5 * dx * dx + dx * dy + dy * dy);
  const Region region = draws::regionOf({a, b}, {0.5, 0.5});
  RC_ASSERT(std::abs(draws::visibilityOf(*draws::make("vsm"), region, c) - expected) < 1e-9);
}

// A split at or above B leaves no variance below it, so that only the smallest variance has an
// effect.
RC_GTEST_PROP(ThreePlanes, DoNotBleedThroughASplit, ()) {
  const double a = draws::between(0.0, 0.4), b = draws::between(a, 0.6);
  const double split = draws::between(std::max(b, 0.01), 0.7);
  const double c = draws::between(split + 0.05, 1.0);
  const auto lvsm = draws::make("lvsm");
  set(*lvsm, "splits", std::vector<double>{split});
  set(*lvsm, "overlap", 0.0);
  const Region region = draws::regionOf({a, b}, {0.5, 0.5});
  const double smallest = minVariance / (minVariance + (c - split) * (c - split));
  RC_ASSERT(std::abs(draws::visibilityOf(*lvsm, region, c) - smallest) < 1e-12);
}

RC_GTEST_PROP(OneLayer, IsVsm, ()) {
  const auto lvsm = draws::make("lvsm"), vsm = draws::make("vsm");
  set(*lvsm, "layers", 1);
  for (const char* name : {"min-variance", "bleed-reduction"})
    if (*rc::gen::arbitrary<bool>()) {
      const double value = name[0] == 'm' ? 1e-4 : 0.3;
      set(*lvsm, name, value);
      set(*vsm, name, value);
    }
  const draws::Place place = draws::place();
  const double receiver = draws::receiverFor(place.region);
  RC_ASSERT(draws::visibilityOf(*lvsm, place.region, receiver) ==
            draws::visibilityOf(*vsm, place.region, receiver));
}

RC_GTEST_PROP(OneLayer, IsThePowerCdf, ()) {
  const auto layered = draws::make("layered-power-cdf");
  set(*layered, "layers", 1);
  const draws::Place place = draws::place();
  const double receiver = draws::receiverFor(place.region);
  RC_ASSERT(draws::visibilityOf(*layered, place.region, receiver) ==
            draws::visibilityOf(*draws::make("power-cdf"), place.region, receiver));
}

// Gumbau 2011, eq. 1: for depths that are distributed as t^β the visibility is the reference at
// the receiver divided by that at the mean. The depths are n quantiles, plus the ends without
// weight. A step of the empirical distribution is 1/n, which eq. 1 divides by at least 0.42; the
// mean is right to 1/(2n), which moves β by (β+1)²/(2n) and v by at most 0.88/β times that: less
// than 8/n together for the β below.
TEST(PowerCdf, IsTheReferenceOverThatOfTheMean) {
  constexpr int n = 20000;
  const double low = 0.15, high = 0.85;
  for (double beta : {0.5, 1.0, 2.0, 5.0}) {
    std::vector<double> depths{low, high}, weights{0.0, 0.0};
    double mean = 0.0;
    for (int i = 0; i < n; ++i) {
      depths.push_back(low + (high - low) * std::pow((i + 0.5) / n, 1.0 / beta));
      weights.push_back(1.0 / n);
      mean += depths.back() / n;
    }
    const Region region = draws::regionOf(depths, weights);
    const auto technique = draws::make("power-cdf");
    const double atMean = referenceVisibility(region, mean);
    for (double receiver = low; receiver < high; receiver += 0.01) {
      const double expected =
          receiver <= mean ? 1.0 : referenceVisibility(region, receiver) / atMean;
      EXPECT_NEAR(draws::visibilityOf(*technique, region, receiver), expected, 8.0 / n)
          << "beta " << beta << ", receiver " << receiver;
    }
  }
}

}  // namespace
}  // namespace umbra
