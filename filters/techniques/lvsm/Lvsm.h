// Layered variance shadow maps (Lauritzen & McCool 2008; Lauritzen 2008, §4.1).
#pragma once

#include "filters/core/technique/Technique.h"
#include "filters/techniques/lvsm/Layers.h"

namespace umbra::lvsm {

struct LvsmParameters : LayerParameters {
  double minVariance = 1e-6;
  double bleedReduction = 0.0;

  static constexpr auto fields() {
    using P = LvsmParameters;
    return std::tuple_cat(
        layerFields<P>(),
        std::tuple{
            Field<P, double>{&P::minVariance, "min-variance", "σ²min", "depth²", 0.0, 1e-2,
                             "Smallest variance that the bound uses, in unwarped depth.",
                             Scale::Logarithmic},
            Field<P, double>{
                &P::bleedReduction, "bleed-reduction", "a", "", 0.0, 0.99,
                "Visibilities up to a become 0, the rest is stretched; darkens penumbrae."},
        });
  }
};

class Lvsm final : public TechniqueWith<Lvsm, LvsmParameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Parameter> parameters() override;
  // The channels are L1M1 L1M2 L2M1 …: two moments of every layer's warped depth.
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

}  // namespace umbra::lvsm
