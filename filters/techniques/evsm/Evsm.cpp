#include "filters/techniques/evsm/Evsm.h"

#include <algorithm>
#include <cmath>

#include "Evsm_glsl.h"
#include "Evsm_md.h"
#include "filters/core/TechniqueCatalogue.h"
#include "filters/techniques/evsm/ExponentLimit.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::evsm {
namespace {

// A warp and its steepness in one number: e^{c(z−½)} for c > 0, −e^{c(z−½)} for c < 0. Both rise
// with z. The shift by ½ is a factor, to which the Chebyshev bound is indifferent.
double warped(double z, double c) {
  return std::copysign(std::exp(c * (z - 0.5)), c);
}

// The moments of one warp, as they are stored.
void encodeWarp(double z, double c, double& first, double& second) {
  first = warped(z, c);
  second = first * first;
}

double boundOfWarp(double m1, double m2, double c, double receiver, double minVariance,
                   double bleedReduction) {
  const double t = warped(receiver, c);
  if (t <= m1) return 1.0;
  // A depth interval at the receiver is longer by the warp's slope there, dg/dz = c·g.
  const double slope = c * t;
  const double bound = chebyshevUpperBound(m1, m2, t, minVariance * slope * slope);
  return reduceLightBleeding(bound, bleedReduction);
}

}  // namespace

const TechniqueInfo& Evsm2::info() const {
  static constexpr TechniqueInfo info{
      .id = "evsm2",
      .title = "Exponential variance, 2 moments (EVSM2)",
      .citation = "Lauritzen 2008, §4.2",
      .summary = "Stores an exponential of depth and its square, and bounds as VSM does.",
      .formula = "v = σ² / (σ² + (g − μ)²) in g = e^(c₊·z), for g(z_r) > μ, else 1",
      .order = 40,
      .upperBound = true,
      .colour = "#3aa76d"};
  return info;
}

std::string Evsm2::refusal(StorageFormat format) const {
  return exponentialRefusal("evsm2", format);
}

std::vector<std::string> Evsm2::limitTo(StorageFormat format) {
  std::vector<std::string> notes;
  limitExponent(values.positiveExponent, largestSquaredExponent(format), "evsm2.positive-exponent",
                format, notes);
  return notes;
}

void Evsm2::encode(double z, std::span<double> channels) const {
  encodeWarp(z, values.positiveExponent, channels[0], channels[1]);
}

double Evsm2::visibility(const Fetch& fetch, double receiver) const {
  return boundOfWarp(fetch.channels[0], fetch.channels[1], values.positiveExponent, receiver,
                     values.minVariance, values.bleedReduction);
}

std::string_view Evsm2::glsl() const {
  return Evsm_glsl;
}
std::string_view Evsm2::page() const {
  return Evsm_md;
}

const TechniqueInfo& Evsm4::info() const {
  static constexpr TechniqueInfo info{
      .id = "evsm4",
      .title = "Exponential variance, 4 moments (EVSM4)",
      .citation = "Lauritzen 2008, §4.2",
      .summary = "Stores a rising and a mirrored exponential of depth with their squares.",
      .formula = "v = min over g₊ = e^(c₊·z), g₋ = −e^(−c₋·z) of σ² / (σ² + (g − μ)²)",
      .order = 41,
      .upperBound = true,
      .colour = "#0b6e4f"};
  return info;
}

std::string Evsm4::refusal(StorageFormat format) const {
  return exponentialRefusal("evsm4", format);
}

std::vector<std::string> Evsm4::limitTo(StorageFormat format) {
  std::vector<std::string> notes;
  const double largest = largestSquaredExponent(format);
  limitExponent(values.positiveExponent, largest, "evsm4.positive-exponent", format, notes);
  limitExponent(values.negativeExponent, largest, "evsm4.negative-exponent", format, notes);
  return notes;
}

void Evsm4::encode(double z, std::span<double> channels) const {
  encodeWarp(z, values.positiveExponent, channels[0], channels[1]);
  encodeWarp(z, -values.negativeExponent, channels[2], channels[3]);
}

double Evsm4::visibility(const Fetch& fetch, double receiver) const {
  const auto bound = [&](std::size_t first, double c) {
    return boundOfWarp(fetch.channels[first], fetch.channels[first + 1], c, receiver,
                       values.minVariance, values.bleedReduction);
  };
  return std::min(bound(0, values.positiveExponent), bound(2, -values.negativeExponent));
}

std::string_view Evsm4::glsl() const {
  return Evsm_glsl;
}
std::string_view Evsm4::page() const {
  return Evsm_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Evsm2>());
  catalogue.add(std::make_unique<Evsm4>());
}

}  // namespace umbra::evsm
