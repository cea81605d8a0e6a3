#include "filters/techniques/csm/Csm.h"

#include <string>

#include "Csm_glsl.h"
#include "Csm_md.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/csm/CsmSum.h"
#include "filters/techniques/csm/Waves.h"

namespace umbra::csm {

const TechniqueInfo& Csm::info() const {
  static constexpr TechniqueInfo info{
      .id = "csm",
      .title = "Convolution (CSM)",
      .citation = "Annen et al. 2007, eq. 13–14",
      .summary = "Stores sines and cosines of depth, the Fourier series of the shadow test.",
      .formula = "v = ½ + 2 Σ (a_k/c_k) (cos(c_k d) S_k − sin(c_k d) C_k), d = z_r − o",
      .order = 60,
      .colour = "#8c6d31"};
  return info;
}

std::vector<Parameter> Csm::parameters() {
  std::vector<Parameter> parameters = TechniqueWith::parameters();
  for (Parameter& parameter : parameters) {
    parameter.put = [this, plain = parameter.put](const ParameterValue& value) {
      plain(value);
      series_ = series();
    };
  }
  return parameters;
}

bool Csm::isKept() const {
  return series_.terms() == values.terms && series_.attenuation() == values.attenuation;
}

FourierSeries Csm::series() const {
  return isKept() ? series_ : FourierSeries(values.terms, values.attenuation);
}

std::vector<Channel> Csm::channels() const {
  std::vector<Channel> channels;
  for (int k = 1; k <= values.terms; ++k) {
    std::string number = std::to_string(k);
    if (k < 10) number.insert(number.begin(), '0');
    channels.push_back({"S" + number, Reduction::Mean, -1.0, 1.0});
    channels.push_back({"C" + number, Reduction::Mean, -1.0, 1.0});
  }
  return channels;
}

void Csm::encode(double z, std::span<double> channels) const {
  Waves waves(z);
  for (int k = 1; k <= values.terms; ++k, waves.next()) {  // eq. 14
    channels[2 * k - 2] = waves.sine();
    channels[2 * k - 1] = waves.cosine();
  }
}

double Csm::visibility(const Fetch& fetch, double receiver) const {
  // The kept series is not copied: this is called for every texel of a map.
  return isKept() ? sumOfTerms(*this, series_, fetch.channels, receiver, Unrecorded())
                  : sumOfTerms(*this, series(), fetch.channels, receiver, Unrecorded());
}

std::string_view Csm::glsl() const {
  return Csm_glsl;
}

std::vector<Uniform> Csm::derivedUniforms() const {
  const FourierSeries fourier = series();
  std::vector<float> coefficients(largestTermCount);
  for (int k = 1; k <= values.terms; ++k) coefficients[k - 1] = float(fourier.coefficient(k));
  return {{"umbra_coefficient", coefficients}, {"umbra_offset", float(fourier.offset())}};
}

std::string_view Csm::page() const {
  return Csm_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Csm>());
}

}  // namespace umbra::csm
