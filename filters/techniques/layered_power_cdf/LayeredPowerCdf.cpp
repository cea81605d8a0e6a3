#include "filters/techniques/layered_power_cdf/LayeredPowerCdf.h"

#include <string>

#include "LayeredPowerCdf_glsl.h"
#include "LayeredPowerCdf_md.h"
#include "Layers_glsl.h"
#include "PowerVisibility_glsl.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/layered_power_cdf/LayeredPowerSum.h"

namespace umbra::layered_power_cdf {

const TechniqueInfo& LayeredPowerCdf::info() const {
  static constexpr TechniqueInfo info{
      .id = "layered-power-cdf",
      .title = "Layered power CDF",
      .citation = "Gumbau et al. 2011, §5",
      .summary =
          "Stores mean, minimum and maximum of depth in layers, each clamped to its interval.",
      .formula = "v = (1 − t^β) / (1 − (β/(β+1))^β) in φ = clamp((z − p)/(q − p), 0, 1)",
      .order = 80,
      .layerChannels = 3,
      .colour = "#c08fd8"};
  return info;
}

std::vector<Channel> LayeredPowerCdf::channels() const {
  std::vector<Channel> channels;
  for (int i = 1; i <= layering().count; ++i) {
    std::string layer = "L";
    layer += std::to_string(i);
    channels.push_back({layer + "mean"});
    channels.push_back({layer + "min", Reduction::Min});
    channels.push_back({layer + "max", Reduction::Max});
  }
  return channels;
}

void LayeredPowerCdf::encode(double z, std::span<double> channels) const {
  const Layering layers = layering();
  for (int i = 0; i < layers.count; ++i)
    channels[3 * i] = channels[3 * i + 1] = channels[3 * i + 2] = layers.warp(i, z);
}

double LayeredPowerCdf::visibility(const Fetch& fetch, double receiver) const {
  return visibilityOf(layering(), fetch.channels, receiver, Unrecorded());
}

std::string_view LayeredPowerCdf::glsl() const {
  static const std::string text =
      std::string(Layers_glsl) + PowerVisibility_glsl + LayeredPowerCdf_glsl;
  return text;
}
std::string_view LayeredPowerCdf::page() const {
  return LayeredPowerCdf_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<LayeredPowerCdf>());
}

}  // namespace umbra::layered_power_cdf
