#include "filters/techniques/power_cdf/PowerCdf.h"

#include "PowerCdf_glsl.h"
#include "PowerCdf_md.h"
#include "PowerVisibility_glsl.h"
#include "filters/core/prefilter/ErrorShares.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/power_cdf/PowerErrors.h"
#include "filters/techniques/power_cdf/PowerVisibility.h"

namespace umbra::power_cdf {

const TechniqueInfo& PowerCdf::info() const {
  static constexpr TechniqueInfo info{
      .id = "power-cdf",
      .title = "Power CDF",
      .citation = "Gumbau et al. 2011, eq. 1–4",
      .summary = "Stores mean, minimum and maximum depth; fits a power function to the CDF.",
      .formula = "v = (1 − t^β) / (1 − (β/(β+1))^β) for z_r > z̄, else 1; β = (z̄ − min)/(max − z̄)",
      .order = 70,
      .colour = "#8e44ad"};
  return info;
}

void PowerCdf::encode(double z, std::span<double> channels) const {
  channels[0] = channels[1] = channels[2] = z;
}

double PowerCdf::visibility(const Fetch& fetch, double receiver) const {
  return powerVisibility(fetch.channels[0], fetch.channels[1], fetch.channels[2], receiver);
}

Trace PowerCdf::explain(const Fetch& fetch, double receiver) const {
  Trace trace;
  const TraceRecorder record(trace);
  record("z_r", "receiver's depth, biased", "", receiver);
  powerVisibility(fetch.channels[0], fetch.channels[1], fetch.channels[2], receiver, record);
  ErrorShares shares(trace, fetch, receiver);
  chargePower(shares, fetch.channels[0], fetch.channels[1], fetch.channels[2], fetch.region,
              receiver, [](double z) { return z; });
  shares.decide("the depths are distributed about as t^β.");
  return trace;
}

std::string_view PowerCdf::glsl() const {
  static const std::string text = std::string(PowerVisibility_glsl) + PowerCdf_glsl;
  return text;
}
std::string_view PowerCdf::page() const {
  return PowerCdf_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<PowerCdf>());
}

}  // namespace umbra::power_cdf
