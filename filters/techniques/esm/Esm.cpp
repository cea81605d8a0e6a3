#include "filters/techniques/esm/Esm.h"

#include <algorithm>
#include <cmath>

#include "Esm_glsl.h"
#include "Esm_md.h"
#include "filters/core/TechniqueCatalogue.h"
#include "filters/techniques/evsm/ExponentLimit.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::esm {

const TechniqueInfo& Esm::info() const {
  static constexpr TechniqueInfo info{
      .id = "esm",
      .title = "Exponential (ESM)",
      .citation = "Salvi 2007",
      .summary = "Stores an exponential of depth; the receiver's own exponential divides it.",
      .formula = "v = min(1, E[e^(c·z)] · e^(−c·z_r))",
      .order = 30,
      .upperBound = true,
      .colour = "#17a2b8"};
  return info;
}

std::string Esm::refusal(StorageFormat format) const {
  return exponentialRefusal("esm", format);
}

std::vector<std::string> Esm::limitTo(StorageFormat format) {
  std::vector<std::string> notes;
  // The exponential itself is stored, not its square.
  limitExponent(values.exponent, 2.0 * largestSquaredExponent(format), "esm.exponent", format,
                notes);
  return notes;
}

// The factor e^{−c/2} cancels in the product and doubles the exponents that do not overflow.
void Esm::encode(double z, std::span<double> channels) const {
  channels[0] = std::exp(values.exponent * (z - 0.5));
}

double Esm::visibility(const Fetch& fetch, double receiver) const {
  const double ratio = fetch.channels[0] * std::exp(-values.exponent * (receiver - 0.5));
  return reduceLightBleeding(std::min(1.0, ratio), values.bleedReduction);
}

std::string_view Esm::glsl() const {
  return Esm_glsl;
}
std::string_view Esm::page() const {
  return Esm_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Esm>());
}

}  // namespace umbra::esm
