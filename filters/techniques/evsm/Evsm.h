// Exponential variance shadow maps (Lauritzen 2008, §4.2): the Chebyshev bound in depth that is
// warped by e^{c₊(z−½)} and, with four moments, also by −e^{−c₋(z−½)}.
#pragma once

#include "filters/core/technique/Technique.h"
#include "filters/techniques/evsm/ExponentLimit.h"
#include "filters/techniques/vsm/BoundFields.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::evsm {

struct Evsm2Parameters {
  double positiveExponent = 40.0;
  double minVariance = 1e-6;
  double bleedReduction = 0.0;

  static constexpr auto fields() {
    using P = Evsm2Parameters;
    return std::tuple{
        Field<P, double>{&P::positiveExponent, "positive-exponent", "c₊", "1/depth", 0.1, 200.0,
                         "Steepness of the warp; larger bleeds less. Float holds 88, half 11.",
                         Scale::Logarithmic},
        minVarianceField<P>(
            "Smallest variance that a bound uses, carried into the warp by its slope."),
        bleedReductionField<P>(),
    };
  }
};

struct Evsm4Parameters {
  double positiveExponent = 40.0;
  double negativeExponent = 5.0;
  double minVariance = 1e-6;
  double bleedReduction = 0.0;

  static constexpr auto fields() {
    using P = Evsm4Parameters;
    return std::tuple{
        Field<P, double>{&P::positiveExponent, "positive-exponent", "c₊", "1/depth", 0.1, 200.0,
                         "Steepness of the warp that draws the second occluder to the first.",
                         Scale::Logarithmic},
        Field<P, double>{&P::negativeExponent, "negative-exponent", "c₋", "1/depth", 0.1, 200.0,
                         "Steepness of the warp that draws it to the receiver instead.",
                         Scale::Logarithmic},
        minVarianceField<P>(
            "Smallest variance that a bound uses, carried into each warp by its slope."),
        bleedReductionField<P>(),
    };
  }
};

class Evsm2 final : public TechniqueWith<Evsm2, Evsm2Parameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Channel> channels() const override { return {{"P1"}, {"P2"}}; }
  std::string refusal(StorageFormat format) const override;
  std::vector<std::string> limitTo(StorageFormat format) override;
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  double amplification() const override { return reductionSlope(values.bleedReduction); }
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;

 private:
  CutExponent cut_;
};

class Evsm4 final : public TechniqueWith<Evsm4, Evsm4Parameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Channel> channels() const override { return {{"P1"}, {"P2"}, {"N1"}, {"N2"}}; }
  std::string refusal(StorageFormat format) const override;
  std::vector<std::string> limitTo(StorageFormat format) override;
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  double amplification() const override { return reductionSlope(values.bleedReduction); }
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;

 private:
  CutExponent cutPositive_, cutNegative_;
};

}  // namespace umbra::evsm
