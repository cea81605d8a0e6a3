#include "filters/techniques/esm/Esm.h"

#include <algorithm>
#include <cmath>

#include "Esm_glsl.h"
#include "Esm_md.h"
#include "filters/core/prefilter/ErrorShares.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/evsm/ExponentLimit.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::esm {

template <class Record>
double Esm::visibilityOf(double mean, double receiver, const Record& record) const {
  record("z_r", "receiver's depth, biased", "", receiver);
  record("c", "exponent", "", values.exponent);
  record("E", "mean of e^(c(z − ½)) over the region", "", mean);
  const double own = record("e_r", "the receiver's own factor", "e^(−c(z_r − ½))",
                            std::exp(-values.exponent * (receiver - 0.5)));
  const double ratio =
      record("E · e_r", "mean of e^(c(z − z_r)): Markov's upper bound", "E · e_r", mean * own);
  const double bound =
      record("p_max", "the bound, cut at 1", "min(1, E · e_r)", std::min(1.0, ratio));
  record("a", "light-bleeding reduction", "", values.bleedReduction);
  return record("v", "visibility", "clamp((p_max − a)/(1 − a), 0, 1)",
                reduceLightBleeding(bound, values.bleedReduction));
}

Trace Esm::explain(const Fetch& fetch, double receiver) const {
  Trace trace;
  visibilityOf(fetch.channels[0], receiver, TraceRecorder(trace));
  ErrorShares shares(trace, fetch, receiver);
  // The contributions of the depths on either side of the receiver to the exact mean, for any
  // exponent.
  const auto part = [&](bool lit, double c) {
    double sum = 0.0;
    for (const RegionTexel& texel : fetch.region.texels)
      if ((texel.depth >= receiver) == lit)
        sum += texel.weight * std::exp(c * (texel.depth - receiver));
    return sum;
  };
  const double ratio = fetch.channels[0] * std::exp(-values.exponent * (receiver - 0.5));
  shares.without(ErrorCause::Reduction, "v", std::min(1.0, ratio),
                 "the light-bleeding reduction takes a part of every penumbra; the bound itself "
                 "is " +
                     shortNumber(std::min(1.0, ratio)) + ".");
  const double c = values.exponent;
  const double exact = std::min(1.0, part(true, c) + part(false, c));
  shares.without(ErrorCause::StoredPrecision, "E", exact,
                 "the stored mean is rounded, by a share of itself; from an exact one v would "
                 "be " +
                     shortNumber(exact) + ".");
  const double asked = cut_.asked(c);
  const double steep = std::min(1.0, part(true, asked) + part(false, asked));
  shares.without(ErrorCause::ExponentLimit, "c", steep, exponentLimitText("c", c, asked, steep));
  const double far = std::min(1.0, part(true, asked));
  shares.without(ErrorCause::ContactLeak, "E · e_r", far,
                 "the receiver is only " + shortNumber(receiver - shares.occlusion().blocking.max) +
                     " behind the occluders' last depth, not many times 1/c = " +
                     shortNumber(1.0 / asked) + " in which the exponential falls off: they count " +
                     shortNumber(part(false, asked)) + " instead of 0.");
  shares.rest(
      ErrorCause::BoundSlack, "E · e_r",
      "depths behind the receiver, at " + rangeText(shares.occlusion().lit) +
          ", should count once each and count e^(c(z − z_r)): " + shortNumber(part(true, asked)) +
          " in all, where " + shortNumber(shares.reference()) + " would be right.");
  shares.decide("what is lit lies at the receiver's depth, and the occluders are far before it.");
  return trace;
}

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
  // The exponential itself is stored, and not its square.
  cut_.limit(values.exponent, 2.0 * largestSquaredExponent(format), "esm.exponent", format, notes);
  return notes;
}

// The factor e^{−c/2} cancels in the product and doubles the exponents that do not overflow.
void Esm::encode(double z, std::span<double> channels) const {
  channels[0] = std::exp(values.exponent * (z - 0.5));
}

double Esm::visibility(const Fetch& fetch, double receiver) const {
  return visibilityOf(fetch.channels[0], receiver, Unrecorded());
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
