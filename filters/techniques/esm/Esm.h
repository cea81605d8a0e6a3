// Exponential shadow maps (Salvi 2007; Annen et al. 2008), with the warp centred on mid-depth.
#pragma once

#include "filters/core/technique/Technique.h"
#include "filters/techniques/evsm/ExponentLimit.h"
#include "filters/techniques/vsm/BoundFields.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::esm {

struct EsmParameters {
  double exponent = 80.0;
  double bleedReduction = 0.0;

  static constexpr auto fields() {
    using P = EsmParameters;
    return std::tuple{
        Field<P, double>{&P::exponent, "exponent", "c", "1/depth", 0.1, 400.0,
                         "Steepness of the warp; larger bleeds less. Float holds 176, half 22.",
                         Scale::Logarithmic},
        bleedReductionField<P>(),
    };
  }
};

class Esm final : public TechniqueWith<Esm, EsmParameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Channel> channels() const override { return {{"E"}}; }
  std::string refusal(StorageFormat format) const override;
  std::vector<std::string> limitTo(StorageFormat format) override;
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  double amplification() const override { return reductionSlope(values.bleedReduction); }
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;

 private:
  template <class Record>
  double visibilityOf(double mean, double receiver, const Record& record) const;

  CutExponent cut_;
};

}  // namespace umbra::esm
