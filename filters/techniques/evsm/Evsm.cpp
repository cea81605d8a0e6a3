#include "filters/techniques/evsm/Evsm.h"

#include "Evsm_glsl.h"
#include "Evsm_md.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/evsm/ExponentLimit.h"
#include "filters/techniques/evsm/Warps.h"

namespace umbra::evsm {
namespace {

WarpSettings settingsOf(const Evsm2Parameters& values) {
  return {values.positiveExponent, 0.0, values.minVariance, values.bleedReduction};
}

WarpSettings settingsOf(const Evsm4Parameters& values) {
  return {values.positiveExponent, values.negativeExponent, values.minVariance,
          values.bleedReduction};
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
  cut_.limit(values.positiveExponent, largestSquaredExponent(format), "evsm2.positive-exponent",
             format, notes);
  return notes;
}

void Evsm2::encode(double z, std::span<double> channels) const {
  encodeWarp(z, values.positiveExponent, channels[0], channels[1]);
}

double Evsm2::visibility(const Fetch& fetch, double receiver) const {
  return visibilityOf(fetch.channels, settingsOf(values), receiver, Unrecorded());
}

Trace Evsm2::explain(const Fetch& fetch, double receiver) const {
  Evsm2 steeper = *this;
  steeper.values.positiveExponent = cut_.asked(values.positiveExponent);
  return explainWarps(*this, settingsOf(values), steeper, settingsOf(steeper.values), fetch,
                      receiver);
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
  cutPositive_.limit(values.positiveExponent, largest, "evsm4.positive-exponent", format, notes);
  cutNegative_.limit(values.negativeExponent, largest, "evsm4.negative-exponent", format, notes);
  return notes;
}

void Evsm4::encode(double z, std::span<double> channels) const {
  encodeWarp(z, values.positiveExponent, channels[0], channels[1]);
  encodeWarp(z, -values.negativeExponent, channels[2], channels[3]);
}

double Evsm4::visibility(const Fetch& fetch, double receiver) const {
  return visibilityOf(fetch.channels, settingsOf(values), receiver, Unrecorded());
}

Trace Evsm4::explain(const Fetch& fetch, double receiver) const {
  Evsm4 steeper = *this;
  steeper.values.positiveExponent = cutPositive_.asked(values.positiveExponent);
  steeper.values.negativeExponent = cutNegative_.asked(values.negativeExponent);
  return explainWarps(*this, settingsOf(values), steeper, settingsOf(steeper.values), fetch,
                      receiver);
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
