#include "filters/techniques/pcf/Pcf.h"

#include <algorithm>

#include "Pcf_glsl.h"
#include "Pcf_md.h"
#include "filters/core/ErrorShares.h"
#include "filters/core/TechniqueCatalogue.h"

namespace umbra::pcf {

const TechniqueInfo& Pcf::info() const {
  static constexpr TechniqueInfo info{
      .id = "pcf",
      .title = "Percentage closer (PCF)",
      .citation = "Reeves, Salesin & Cook 1987",
      .summary =
          "Stores depth and compares every texel of the region: exact, but not prefilterable.",
      .formula = "v = Σ w_i [z_i ≥ z_r]",
      .order = 10,
      .prefilterable = false,
      .colour = "#1f2933"};
  return info;
}

void Pcf::encode(double z, std::span<double> channels) const {
  channels[0] = z;
}

double Pcf::visibility(const Fetch& fetch, double receiver) const {
  return referenceVisibility(fetch.region, receiver);
}

Trace Pcf::explain(const Fetch& fetch, double receiver) const {
  Trace trace;
  const TraceRecorder record(trace);
  const auto& texels = fetch.region.texels;
  const auto lit = std::count_if(texels.begin(), texels.end(),
                                 [&](const RegionTexel& texel) { return texel.depth >= receiver; });
  record("z_r", "receiver's depth, biased", "", receiver);
  record("n", "taps of the region", "", double(texels.size()));
  record("n_lit", "taps at or behind the receiver", "count of z_i ≥ z_r", double(lit));
  record("v", "visibility: the weight of these taps", "Σ w_i [z_i ≥ z_r]",
         visibility(fetch, receiver));
  ErrorShares shares(trace, fetch, receiver);
  shares.rest(ErrorCause::Sampling, "v", "not all taps are compared.");
  shares.decide("every tap is compared, and the answers are averaged: that is the definition.");
  return trace;
}

std::string_view Pcf::glsl() const {
  return Pcf_glsl;
}
std::string_view Pcf::page() const {
  return Pcf_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Pcf>());
}

}  // namespace umbra::pcf
