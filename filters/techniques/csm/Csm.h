// Convolution shadow maps (Annen, Mertens, Bekaert, Seidel & Kautz 2007).
#pragma once

#include <array>

#include "filters/core/technique/Technique.h"
#include "filters/techniques/csm/FourierSeries.h"

namespace umbra::csm {

// How a surface is made lit, although the series is ½ on it (§3.2.2).
enum class Mode { Offset, Scale };
inline constexpr std::array<std::string_view, 2> modeNames{"offset", "scale"};

struct CsmParameters {
  int terms = 4;
  double attenuation = 0.0;
  Mode mode = Mode::Offset;

  static constexpr auto fields() {
    using P = CsmParameters;
    return std::tuple{
        Field<P, int>{&P::terms, "terms", "M", "", 1, largestTermCount,
                      "Terms of the series, two channels each; more are steeper and ring faster."},
        Field<P, double>{&P::attenuation, "attenuation", "α", "", 0.0, 10.0,
                         "Damps term k by exp(−α(k/M)²): less ringing, but a less steep step."},
        Field<P, Mode>{&P::mode, "mode", "", "", Mode::Offset, Mode::Scale,
                       "What lights lit surfaces: move the receiver, or double the series.",
                       Scale::Linear, modeNames},
    };
  }
};

class Csm final : public TechniqueWith<Csm, CsmParameters> {
 public:
  const TechniqueInfo& info() const override;
  using TechniqueWith::parameters;
  std::vector<Parameter> parameters() override;
  // S01 C01 S02 C02 …, each in [−1, 1].
  std::vector<Channel> channels() const override;
  void encode(double z, std::span<double> channels) const override;
  double visibility(const Fetch& fetch, double receiver) const override;
  Trace explain(const Fetch& fetch, double receiver) const override;
  std::string_view glsl() const override;
  std::vector<Uniform> derivedUniforms() const override;
  std::string_view page() const override;

  // The series for the present parameters.
  FourierSeries series() const;

 private:
  bool isKept() const;

  // Finding the offset takes long, so the series is kept with the parameters that it is for.
  // Only a change of parameters replaces it: visibility() may run in many threads.
  FourierSeries series_;
};

}  // namespace umbra::csm
