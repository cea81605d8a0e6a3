// The power CDF in depth layers (Gumbau et al. 2011, §2 and §5: "in the same way as layered
// variance shadow maps").
#pragma once

#include "filters/core/technique/Technique.h"
#include "filters/techniques/lvsm/Layers.h"

namespace umbra::layered_power_cdf {

struct LayeredPowerCdfParameters : LayerParameters {
  static constexpr auto fields() { return layerFields<LayeredPowerCdfParameters>(); }
};

class LayeredPowerCdf final : public TechniqueWith<LayeredPowerCdf, LayeredPowerCdfParameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Parameter> parameters() override;
  // The channels are L1mean L1min L1max L2mean …, of every layer's warped depth.
  std::vector<Channel> channels() const override;
  // Must be called again after a change of layers or placement.
  void adapt(const DepthMap& map) override;
  int adaptedSplitCount() const override { return umbra::adaptedSplitCount(values); }
  void setAdaptedSplits(std::span<const double> splits) override;
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::vector<Uniform> derivedUniforms() const override;
  std::string_view page() const override;

  Layering layering() const { return layeringOf(values, adaptedSplits_); }

 private:
  std::vector<double> adaptedSplits_;
};

}  // namespace umbra::layered_power_cdf
