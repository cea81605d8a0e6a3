// Power CDF shadow maps (Gumbau, Szirmay-Kalos, Sbert & Chover 2011).
#pragma once

#include "filters/core/technique/Technique.h"

namespace umbra::power_cdf {

class PowerCdf final : public TechniqueWith<PowerCdf, NoParameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Channel> channels() const override {
    return {{"mean"}, {"min", Reduction::Min}, {"max", Reduction::Max}};
  }
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;
};

}  // namespace umbra::power_cdf
