// A trace ends in the visibility, and blames the step for which a region was constructed.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/VisibleError.h"
#include "filters/techniques/csm/Csm.h"
#include "filters/techniques/esm/Esm.h"
#include "filters/techniques/evsm/Evsm.h"
#include "filters/techniques/lvsm/Lvsm.h"
#include "filters/techniques/msm/Msm.h"
#include "filters/techniques/vsm/Vsm.h"
#include "tests/properties/Draws.h"

namespace umbra {
namespace {

class TraceOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, TraceOf, testing::ValuesIn(draws::techniqueIds()),
                         [](const auto& drawn) { return draws::caseName(drawn.param); });

TEST_P(TraceOf, EndsInTheVisibilityWhateverIsRead) {
  rc::detail::checkGTest([&] {
    const auto technique = draws::make(GetParam());
    draws::parametersOf(*technique);
    const StorageFormat format = draws::formatFor(*technique);
    const draws::Place place = draws::place();
    technique->adapt(place.map);
    const std::vector<double> channels = prefilteredRegion(place.region, *technique, format);
    const Fetch fetch{channels, place.region};
    const double receiver = draws::receiverFor(place.region);
    const double visibility = technique->visibility(fetch, receiver);
    const Trace trace = technique->explain(fetch, receiver);
    RC_ASSERT(!trace.steps.empty());
    RC_ASSERT(trace.steps.back().value == visibility);
    RC_ASSERT(!trace.sentence.empty());
    // The shares account for the whole error. Each is a difference of numbers up to 1.
    const double error = visibility - referenceVisibility(place.region, receiver);
    double sum = 0.0;
    for (const ErrorShare& share : trace.shares) {
      RC_ASSERT(share.step >= 0 && share.step < int(trace.steps.size()));
      sum += share.amount;
    }
    RC_ASSERT(std::abs(sum - error) <= 1e-15 * double(trace.shares.size() + 1));
    RC_ASSERT((trace.cause == ErrorCause::None) == !isVisibleError(error));
    RC_ASSERT(trace.culprit.has_value() == (trace.cause != ErrorCause::None));
  });
}

Trace traceOf(const Technique& technique, const Region& region, double receiver,
              StorageFormat format = StorageFormat::Double) {
  const std::vector<double> channels = prefilteredRegion(region, technique, format);
  return technique.explain({channels, region}, receiver);
}

// The cause and the step that is blamed for it.
void expectCause(const Trace& trace, ErrorCause cause, std::string_view symbol) {
  EXPECT_EQ(nameOf(trace.cause), nameOf(cause)) << trace.sentence;
  ASSERT_TRUE(trace.culprit.has_value());
  EXPECT_EQ(trace.steps[*trace.culprit].symbol, symbol) << trace.sentence;
}

TEST(TraceCause, NoneForTwoPlanes) {
  const Trace trace = traceOf(vsm::Vsm(), draws::regionOf({0.3, 0.8}, {0.75, 0.25}), 0.8);
  EXPECT_EQ(trace.cause, ErrorCause::None);
  EXPECT_NEAR(trace.steps.back().value, 0.25, 1e-12);
}

TEST(TraceCause, OccludersFarApart) {
  const Trace trace = traceOf(vsm::Vsm(), draws::regionOf({0.2, 0.6}, {0.5, 0.5}), 0.75);
  expectCause(trace, ErrorCause::DistantVariance, "σ²");
  EXPECT_NE(trace.sentence.find("0.2 … 0.6"), std::string::npos) << trace.sentence;
}

TEST(TraceCause, EarlyOut) {
  expectCause(traceOf(vsm::Vsm(), draws::regionOf({0.5, 1.0}, {0.5, 0.5}), 0.6),
              ErrorCause::EarlyOut, "t − μ");
}

TEST(TraceCause, SlackOfTheBound) {
  expectCause(traceOf(vsm::Vsm(), draws::regionOf({0.2, 1.0}, {0.7, 0.3}), 0.6),
              ErrorCause::BoundSlack, "p_max");
}

TEST(TraceCause, SmallestVariance) {
  vsm::Vsm technique;
  technique.values.minVariance = 1e-2;
  expectCause(traceOf(technique, draws::regionOf({0.4}, {1.0}), 0.5), ErrorCause::VarianceClamp,
              "σ²₊");
}

TEST(TraceCause, Reduction) {
  vsm::Vsm technique;
  technique.values.bleedReduction = 0.5;
  expectCause(traceOf(technique, draws::regionOf({0.3, 0.8}, {0.5, 0.5}), 0.8),
              ErrorCause::Reduction, "v");
}

TEST(TraceCause, HalfFloatsLoseTheVariance) {
  vsm::Vsm technique;
  technique.values.minVariance = 0.0;
  // The spread is 0.005; half floats hold the squares of these depths to 0.00024.
  const Region region = draws::regionOf({0.9, 0.91}, {0.5, 0.5});
  expectCause(traceOf(technique, region, 0.91, StorageFormat::Half), ErrorCause::StoredPrecision,
              "σ²");
}

TEST(TraceCause, AnExponentThatHalfFloatsCut) {
  evsm::Evsm2 technique;
  technique.limitTo(StorageFormat::Half);
  const Trace trace =
      traceOf(technique, draws::regionOf({0.2, 0.6}, {0.5, 0.5}), 0.7, StorageFormat::Half);
  expectCause(trace, ErrorCause::ExponentLimit, "c₊");
  EXPECT_NE(trace.sentence.find("c₊ ≤ 11 where 40"), std::string::npos) << trace.sentence;
  technique.values.positiveExponent = 5.0;  // this exponent was asked for: nothing cuts it
  EXPECT_NE(traceOf(technique, draws::regionOf({0.2, 0.6}, {0.5, 0.5}), 0.7).cause,
            ErrorCause::ExponentLimit);
}

TEST(TraceCause, ContactsLeak) {
  const Region region = draws::regionOf({0.595}, {1.0});
  expectCause(traceOf(esm::Esm(), region, 0.6), ErrorCause::ContactLeak, "E · e_r");
  expectCause(traceOf(csm::Csm(), region, 0.6), ErrorCause::ContactLeak, "d");
  expectCause(traceOf(evsm::Evsm4(), draws::regionOf({0.58, 0.599}, {0.5, 0.5}), 0.6),
              ErrorCause::ContactLeak, "σ²₊");
}

TEST(TraceCause, DepthsBehindTheReceiverCountTooMuch) {
  expectCause(traceOf(esm::Esm(), draws::regionOf({0.1, 0.63}, {0.9, 0.1}), 0.6),
              ErrorCause::BoundSlack, "E · e_r");
}

// Behind the first trough of four terms, the series has its next crest.
TEST(TraceCause, Ringing) {
  csm::Csm technique;
  technique.values.terms = 2;
  double worst = 0.0, at = 0.0;
  for (double d = 0.3; d < 0.9; d += 0.001) {
    const double v = draws::visibilityOf(technique, draws::regionOf({0.05}, {1.0}), 0.05 + d);
    if (v > worst) worst = v, at = 0.05 + d;
  }
  ASSERT_GT(worst, visibleError);
  expectCause(traceOf(technique, draws::regionOf({0.05}, {1.0}), at), ErrorCause::Ringing, "f");
}

TEST(TraceCause, WrappingOfTheSeries) {
  expectCause(traceOf(csm::Csm(), draws::regionOf({1.0}, {1.0}), 0.0), ErrorCause::Wrapping, "f");
}

TEST(TraceCause, ALayersEnd) {
  lvsm::Lvsm technique;
  technique.values.layers = 2;
  const Trace trace = traceOf(technique, draws::regionOf({0.2, 0.6}, {0.5, 0.5}), 0.52);
  expectCause(trace, ErrorCause::LayerCut, "t₂");
}

TEST(TraceCause, CollapsedPenumbra) {
  const auto technique = draws::make("power-cdf");
  expectCause(traceOf(*technique, draws::regionOf({0.3, 0.8}, {0.5, 0.5}), 0.8),
              ErrorCause::CollapsedPenumbra, "max");
}

TEST(TraceCause, DepthsThatNoPowerFunctionFits) {
  const auto technique = draws::make("power-cdf");
  const Region region = draws::regionOf({0.2, 0.55, 1.0}, {0.2, 0.6, 0.2});
  expectCause(traceOf(*technique, region, 0.65), ErrorCause::Misfit, "β");
}

TEST(TraceCause, OneTexelForAll) {
  const auto technique = draws::make("hard");
  expectCause(traceOf(*technique, draws::regionOf({0.8, 0.3}, {0.5, 0.5}), 0.8),
              ErrorCause::Sampling, "z");
}

TEST(TraceCause, MoreDepthsThanFourMomentsTell) {
  const Region region = draws::regionOf({0.1, 0.3, 0.5, 0.65}, {0.25, 0.25, 0.25, 0.25});
  expectCause(traceOf(msm::Msm(), region, 0.7), ErrorCause::BoundSlack, "p_max");
}

}  // namespace
}  // namespace umbra
