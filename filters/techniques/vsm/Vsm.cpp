#include "filters/techniques/vsm/Vsm.h"

#include "Vsm_glsl.h"
#include "Vsm_md.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/vsm/Chebyshev.h"
#include "filters/techniques/vsm/VarianceErrors.h"

namespace umbra::vsm {

const TechniqueInfo& Vsm::info() const {
  static constexpr TechniqueInfo info{
      .id = "vsm",
      .title = "Variance (VSM)",
      .citation = "Lauritzen 2008, eq. 3.3",
      .summary = "Stores depth and its square; the variance of the region bounds the visibility.",
      .formula = "v = σ² / (σ² + (z_r − μ)²) for z_r > μ, else 1",
      .order = 20,
      .upperBound = true,
      .colour = "#2563c9"};
  return info;
}

void Vsm::encode(double z, std::span<double> channels) const {
  channels[0] = z;
  channels[1] = z * z;
}

double Vsm::visibility(const Fetch& fetch, double receiver) const {
  return chebyshevVisibility(fetch.channels[0], fetch.channels[1], receiver, values.minVariance,
                             values.bleedReduction, Unrecorded());
}

Trace Vsm::explain(const Fetch& fetch, double receiver) const {
  Trace trace;
  const TraceRecorder record(trace);
  record("t = z_r", "receiver's depth, biased", "", receiver);
  chebyshevVisibility(fetch.channels[0], fetch.channels[1], receiver, values.minVariance,
                      values.bleedReduction, record);
  ErrorShares shares(trace, fetch, receiver);
  const auto evaluate = [&](std::span<const double> channels, const BoundSettings& settings) {
    return chebyshevVisibility(channels[0], channels[1], receiver,
                               settings.minVariance ? values.minVariance : 0.0,
                               settings.reduction ? values.bleedReduction : 0.0, Unrecorded());
  };
  const std::vector<double> exact = chargeSettings(shares, *this, fetch, evaluate);
  const std::vector<double> together = withoutSpread(*this, fetch.region, receiver);
  chargeSpread(shares, evaluate(together, {false, false}), receiver <= exact[0], receiver,
               ErrorCause::DistantVariance,
               "Chebyshev's bound knows only their variance, which is large beside the receiver's "
               "distance, and cannot tell them from depths behind the receiver.");
  shares.decide("occluder and receiver are two depths, for which the bound is reached.");
  return trace;
}

std::string_view Vsm::glsl() const {
  return Vsm_glsl;
}
std::string_view Vsm::page() const {
  return Vsm_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Vsm>());
}

}  // namespace umbra::vsm
