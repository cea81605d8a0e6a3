// Variance shadow maps (Donnelly & Lauritzen 2006; Lauritzen 2008, chapter 3).
#pragma once

#include "filters/core/technique/Technique.h"
#include "filters/techniques/vsm/BoundFields.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::vsm {

struct VsmParameters {
  double minVariance = 1e-6;
  double bleedReduction = 0.0;

  static constexpr auto fields() {
    using P = VsmParameters;
    return std::tuple{
        minVarianceField<P>(
            "Smallest variance that the bound uses; hides rounding, blurs contacts."),
        bleedReductionField<P>(),
    };
  }
};

class Vsm final : public TechniqueWith<Vsm, VsmParameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Channel> channels() const override { return {{"M1"}, {"M2"}}; }
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  double amplification() const override { return reductionSlope(values.bleedReduction); }
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;
};

}  // namespace umbra::vsm
