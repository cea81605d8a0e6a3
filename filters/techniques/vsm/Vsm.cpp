#include "filters/techniques/vsm/Vsm.h"

#include "Vsm_glsl.h"
#include "Vsm_md.h"
#include "filters/core/TechniqueCatalogue.h"
#include "filters/techniques/vsm/Chebyshev.h"

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
  const double m1 = fetch.channels[0], m2 = fetch.channels[1];
  if (receiver <= m1) return 1.0;
  const double bound = chebyshevUpperBound(m1, m2, receiver, values.minVariance);
  return reduceLightBleeding(bound, values.bleedReduction);
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
