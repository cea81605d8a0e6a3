#include "filters/techniques/pcf/Pcf.h"

#include "Pcf_glsl.h"
#include "Pcf_md.h"
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
