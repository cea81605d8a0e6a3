// Percentage-closer filtering (Reeves, Salesin & Cook 1987): compare texels, then average. With all
// texels of the region it is the reference that every other technique is measured against.
#pragma once

#include <array>

#include "filters/core/technique/Technique.h"
#include "filters/techniques/pcf/PoissonDisc.h"

namespace umbra::pcf {

// Which texels are compared: all of the region, or those under a turned disc of points (Isidoro
// 2006), which leaves noise.
enum class Taps { All, Poisson };
inline constexpr std::array<std::string_view, 2> tapsNames{"all", "poisson"};

struct PcfParameters {
  Taps taps = Taps::All;
  int poissonTaps = 16;

  static constexpr auto fields() {
    using P = PcfParameters;
    return std::tuple{
        Field<P, Taps>{&P::taps, "taps", "", "", Taps::All, Taps::Poisson,
                       "Compares all texels of the region, or a disc of points turned per texel.",
                       Scale::Linear, tapsNames},
        Field<P, int>{&P::poissonTaps, "poisson-taps", "n", "", 4, largestTapCount,
                      "Points of the disc; fewer cost less and leave more noise."},
    };
  }
};

class Pcf final : public TechniqueWith<Pcf, PcfParameters> {
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
