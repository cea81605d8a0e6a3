// Which part of a truncated Fourier series makes its visibility wrong.
#include "filters/core/prefilter/ErrorShares.h"
#include "filters/core/support/Text.h"
#include "filters/techniques/csm/CsmSum.h"

namespace umbra::csm {
namespace {

// How much each group of the region's depths adds to the sum beyond its exact share.
struct Excess {
  double wrapped = 0.0;  // the series repeats where the depths are a whole period apart
  double contact = 0.0;  // blockers so near that the series is on its way up to the lit side
  double doubled = 0.0;  // scale mode: what is lit counts twice
  double ringing = 0.0;  // the swings about 0 and 1
  double nearest = 1.0;  // distance of the last blocker within the rise
};

// The step falls from its first maximum at 1/(2M) to its first minimum at −1/(2M) where no term is
// attenuated.
Excess excessOf(const Csm& csm, const FourierSeries& fourier, const Region& region,
                double receiver) {
  const bool offset = csm.values.mode == Mode::Offset;
  const double shift = offset ? fourier.offset() : 0.0;
  const double rise = 0.5 / csm.values.terms;
  Excess excess;
  for (const RegionTexel& texel : region.texels) {
    const double distance = texel.depth - receiver, t = distance + shift;
    const bool lit = distance >= 0.0;
    const double excessHere =
        texel.weight * ((offset ? 1.0 : 2.0) * fourier(t) - (lit ? 1.0 : 0.0));
    if (t >= 1.0 || t <= -1.0) {
      excess.wrapped += excessHere;
    } else if (!lit && t > -rise) {
      excess.contact += excessHere;
      excess.nearest = std::min(excess.nearest, -distance);
    } else if (!offset && lit && distance > 0.0) {
      excess.doubled += texel.weight;
      excess.ringing += excessHere - texel.weight;
    } else {
      excess.ringing += excessHere;
    }
  }
  return excess;
}

}  // namespace

Trace Csm::explain(const Fetch& fetch, double receiver) const {
  const FourierSeries fourier = series();
  Trace trace;
  sumOfTerms(*this, fourier, fetch.channels, receiver, TraceRecorder(trace));
  ErrorShares shares(trace, fetch, receiver);
  const double precise =
      sumOfTerms(*this, fourier, exactMeans(*this, fetch), receiver, Unrecorded());
  shares.without(ErrorCause::StoredPrecision, "f", precise,
                 "the stored sines and cosines are rounded; from exact ones v would be " +
                     shortNumber(precise) + ".");
  const Excess excess = excessOf(*this, fourier, fetch.region, receiver);
  double sum =
      shares.reference() + excess.wrapped + excess.contact + excess.doubled + excess.ringing;
  const auto without = [&](ErrorCause cause, std::string_view symbol, double amount,
                           std::string sentence) {
    sum -= amount;
    shares.without(cause, symbol, std::clamp(sum, 0.0, 1.0), std::move(sentence));
  };
  without(ErrorCause::Wrapping, "f", excess.wrapped,
          "the series repeats after a depth of 2, and depths at the far end of the range come "
          "round to the other side of the step: " +
              shortNumber(excess.wrapped) + ".");
  without(ErrorCause::ContactLeak, values.mode == Mode::Offset ? "d" : "2f", excess.contact,
          "occluders " + shortNumber(excess.nearest) +
              " before the receiver are within the rise "
              "of a step of M = " +
              std::to_string(values.terms) + " terms and count " + shortNumber(excess.contact) +
              " instead of 0.");
  without(ErrorCause::Misfit, "2f", excess.doubled,
          "scaling counts what lies behind the receiver, " + shortNumber(excess.doubled) +
              " of the region, twice.");
  shares.rest(ErrorCause::Ringing, "f",
              "the series of M = " + std::to_string(values.terms) +
                  " terms swings about the step it stands for, by " + shortNumber(excess.ringing) +
                  " over this region's depths.");
  shares.decide("the series swings about the step only a little at these depths.");
  return trace;
}

}  // namespace umbra::csm
