// Percentage-closer filtering (Reeves, Salesin & Cook 1987): compare every texel, then average.
// It is the reference that every other technique is measured against.
#pragma once

#include "filters/core/Technique.h"

namespace umbra::pcf {

class Pcf final : public TechniqueWith<Pcf, NoParameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Channel> channels() const override { return {{"z"}}; }
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;
};

}  // namespace umbra::pcf
