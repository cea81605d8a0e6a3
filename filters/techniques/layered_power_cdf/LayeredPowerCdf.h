// The power CDF in depth layers (Gumbau et al. 2011, §2 and §5: "in the same way as layered
// variance shadow maps").
#pragma once

#include "filters/techniques/lvsm/LayeredTechnique.h"

namespace umbra::layered_power_cdf {

struct LayeredPowerCdfParameters : LayerParameters {
  static constexpr auto fields() { return layerFields<LayeredPowerCdfParameters>(); }
};

class LayeredPowerCdf final : public LayeredTechnique<LayeredPowerCdf, LayeredPowerCdfParameters> {
 public:
  const TechniqueInfo& info() const override;
  // The channels are L1mean L1min L1max L2mean …, of every layer's warped depth.
  std::vector<Channel> channels() const override;
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;
};

}  // namespace umbra::layered_power_cdf
