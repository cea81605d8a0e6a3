// Layered variance shadow maps (Lauritzen & McCool 2008; Lauritzen 2008, §4.1).
#pragma once

#include "filters/techniques/lvsm/LayeredTechnique.h"
#include "filters/techniques/vsm/BoundFields.h"
#include "filters/techniques/vsm/Chebyshev.h"

namespace umbra::lvsm {

struct LvsmParameters : LayerParameters {
  double minVariance = 1e-6;
  double bleedReduction = 0.0;

  static constexpr auto fields() {
    using P = LvsmParameters;
    return std::tuple_cat(
        layerFields<P>(),
        std::tuple{
            minVarianceField<P>("Smallest variance that the bound uses, in unwarped depth."),
            bleedReductionField<P>(),
        });
  }
};

class Lvsm final : public LayeredTechnique<Lvsm, LvsmParameters> {
 public:
  const TechniqueInfo& info() const override;
  // The channels are L1M1 L1M2 L2M1 …: two moments of every layer's warped depth.
  std::vector<Channel> channels() const override;
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  double amplification() const override { return reductionSlope(values.bleedReduction); }
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;
};

}  // namespace umbra::lvsm
