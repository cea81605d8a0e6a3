#include "filters/techniques/lvsm/Lvsm.h"

#include <string>

#include "Layers_glsl.h"
#include "Lvsm_glsl.h"
#include "Lvsm_md.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/lvsm/LvsmSum.h"

namespace umbra::lvsm {

const TechniqueInfo& Lvsm::info() const {
  static constexpr TechniqueInfo info{
      .id = "lvsm",
      .title = "Layered variance (LVSM)",
      .citation = "Lauritzen 2008, eq. 4.2",
      .summary = "Stores the two moments of depth in layers, each clamped to its own interval.",
      .formula = "v = σ² / (σ² + (φ − μ)²) in φ = clamp((z − p)/(q − p), 0, 1) of z_r's layer",
      .order = 50,
      .upperBound = true,
      .layerChannels = 2,
      .colour = "#7aa6f0"};
  return info;
}

std::vector<Channel> Lvsm::channels() const {
  std::vector<Channel> channels;
  for (int i = 1; i <= layering().count; ++i) {
    std::string layer = "L";
    layer += std::to_string(i);
    channels.push_back({layer + "M1"});
    channels.push_back({layer + "M2"});
  }
  return channels;
}

void Lvsm::encode(double z, std::span<double> channels) const {
  const Layering layers = layering();
  for (int i = 0; i < layers.count; ++i) {
    const double warped = layers.warp(i, z);
    channels[2 * i] = warped;
    channels[2 * i + 1] = warped * warped;
  }
}

double Lvsm::visibility(const Fetch& fetch, double receiver) const {
  return visibilityOf(layering(), fetch.channels, values.minVariance, values.bleedReduction,
                      receiver, Unrecorded());
}

std::string_view Lvsm::glsl() const {
  static const std::string text = std::string(Layers_glsl) + Lvsm_glsl;
  return text;
}
std::string_view Lvsm::page() const {
  return Lvsm_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Lvsm>());
}

}  // namespace umbra::lvsm
