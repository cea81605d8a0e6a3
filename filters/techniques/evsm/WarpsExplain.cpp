// Which step of an exponentially warped bound goes wrong.
#include "filters/core/support/Text.h"
#include "filters/techniques/evsm/ExponentLimit.h"
#include "filters/techniques/evsm/Warps.h"
#include "filters/techniques/vsm/VarianceErrors.h"

namespace umbra::evsm {
namespace {

// The suffix of the steps of the warp that decided: the one with the smaller bound.
std::string deciding(const Trace& trace) {
  double rising = 1.0, mirrored = 2.0;
  for (const TraceStep& step : trace.steps) {
    if (step.symbol == "v₊") rising = step.value;
    if (step.symbol == "v₋") mirrored = step.value;
  }
  return rising <= mirrored ? "₊" : "₋";
}

double evaluate(std::span<const double> channels, WarpSettings settings, double receiver,
                const BoundSettings& heeded) {
  if (!heeded.reduction) settings.bleedReduction = 0.0;
  if (!heeded.minVariance) settings.minVariance = 0.0;
  return visibilityOf(channels, settings, receiver, Unrecorded());
}

// Whether no warp has the receiver behind its mean.
bool isEarly(std::span<const double> exact, const WarpSettings& settings, double receiver) {
  return warped(receiver, settings.positiveExponent) <= exact[0] &&
         (settings.negativeExponent == 0.0 ||
          warped(receiver, -settings.negativeExponent) <= exact[2]);
}

void chargeWarps(ErrorShares& shares, const Technique& technique, const WarpSettings& settings,
                 const Fetch& fetch, double receiver) {
  const double gap = receiver - shares.occlusion().blocking.max;
  const double resolved = 1.0 / settings.positiveExponent;
  const double together = evaluate(withoutSpread(technique, fetch.region, receiver), settings,
                                   receiver, {false, false});
  const bool early = isEarly(exactMeans(technique, fetch), settings, receiver);
  if (gap < resolved)
    chargeSpread(shares, together, early, receiver, ErrorCause::ContactLeak,
                 "That is within 1/c₊ = " + shortNumber(resolved) +
                     ", over which the warp is nearly straight, and the light bleeds as in VSM.");
  else
    chargeSpread(shares, together, early, receiver, ErrorCause::DistantVariance,
                 "Their variance is large beside the receiver's distance even after the warp.");
}

}  // namespace

Trace explainWarps(const Technique& technique, const WarpSettings& settings,
                   const Technique& steeper, const WarpSettings& asked, const Fetch& fetch,
                   double receiver) {
  Trace trace;
  visibilityOf(fetch.channels, settings, receiver, TraceRecorder(trace));
  const std::string suffix = deciding(trace);
  ErrorShares shares(trace, fetch, receiver, suffix);
  chargeSettings(shares, technique, fetch,
                 [&](std::span<const double> channels, const BoundSettings& heeded) {
                   return evaluate(channels, settings, receiver, heeded);
                 });
  const double steep = evaluate(exactMeans(steeper, fetch), asked, receiver, {false, false});
  const bool cutNegative = asked.negativeExponent != settings.negativeExponent;
  const bool cutPositive = asked.positiveExponent != settings.positiveExponent;
  const bool negative = cutNegative && !(cutPositive && suffix == "₊");
  shares.without(
      ErrorCause::ExponentLimit, "c", steep,
      exponentLimitText(negative ? "c₋" : "c₊",
                        negative ? settings.negativeExponent : settings.positiveExponent,
                        negative ? asked.negativeExponent : asked.positiveExponent, steep));
  chargeWarps(shares, steeper, asked, fetch, receiver);
  shares.decide("in the warp, occluder and receiver are nearly two depths.");
  return trace;
}

}  // namespace umbra::evsm
