// Moment shadow maps with four moments (Peters & Klein 2015).
#pragma once

#include <array>

#include "filters/core/technique/Technique.h"
#include "filters/techniques/vsm/BoundFields.h"

namespace umbra::msm {

// The four channels are the power moments, or their optimised quantisation.
enum class Basis { Moments, Quantised };
inline constexpr std::array<std::string_view, 2> basisNames{"moments", "quantised"};

struct MsmParameters {
  double momentBias = 3e-5;
  double bleedReduction = 0.0;
  Basis basis = Basis::Moments;

  static constexpr auto fields() {
    using P = MsmParameters;
    return std::tuple{
        Field<P, double>{&P::momentBias, "moment-bias", "α", "", 1e-9, 1e-1,
                         "Moves the moments towards ½, so that rounded ones still fit a depth.",
                         Scale::Logarithmic},
        bleedReductionField<P>(),
        Field<P, Basis>{&P::basis, "basis", "", "", Basis::Moments, Basis::Quantised,
                        "Stores the moments, or mixtures that fill a 16-bit normalised range.",
                        Scale::Linear, basisNames},
    };
  }
};

class Msm final : public TechniqueWith<Msm, MsmParameters> {
 public:
  const TechniqueInfo& info() const override;
  std::vector<Channel> channels() const override { return {{"M1"}, {"M2"}, {"M3"}, {"M4"}}; }
  // Formats coarser than float set the basis to quantised and may raise the moment bias.
  std::vector<std::string> limitTo(StorageFormat format) override;
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  double amplification() const override;
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::string_view page() const override;
};

}  // namespace umbra::msm
