#include "filters/techniques/hard/Hard.h"

#include "Hard_glsl.h"
#include "Hard_md.h"
#include "filters/core/TechniqueCatalogue.h"

namespace umbra::hard {

const TechniqueInfo& Hard::info() const {
  static constexpr TechniqueInfo info{
      .id = "hard",
      .title = "Hard shadow map",
      .citation = "Williams 1978",
      .summary = "Stores depth and compares the one texel nearest to the read position.",
      .formula = "v = 1 for z_r ≤ z, else 0",
      .order = 0,
      .prefilterable = false,
      .colour = "#9aa5b1"};
  return info;
}

void Hard::encode(double z, std::span<double> channels) const {
  channels[0] = z;
}

double Hard::visibility(const Fetch& fetch, double receiver) const {
  return receiver <= fetch.region.nearestDepth ? 1.0 : 0.0;
}

std::string_view Hard::glsl() const {
  return Hard_glsl;
}
std::string_view Hard::page() const {
  return Hard_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Hard>());
}

}  // namespace umbra::hard
