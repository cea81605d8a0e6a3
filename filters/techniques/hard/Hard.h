// The plain shadow map (Williams 1978): one comparison at the nearest texel, no filter.
#pragma once

#include "filters/core/technique/Technique.h"

namespace umbra::hard {

class Hard final : public TechniqueWith<Hard, NoParameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Channel> channels() const override { return {{"z"}}; }
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;
};

}  // namespace umbra::hard
