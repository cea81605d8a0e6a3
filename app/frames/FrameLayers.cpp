#include "app/frames/FrameLayers.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace umbra {
namespace {

// IEC 61966-2-1.
float linearOf(std::uint8_t byte) {
  const double value = byte / 255.0;
  return float(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
}

Image<float> linearChannel(const Image<std::uint8_t>& colour, int channel) {
  Image<float> linear(colour.width(), colour.height());
  for (int y = 0; y < colour.height(); ++y)
    for (int x = 0; x < colour.width(); ++x) linear(x, y) = linearOf(colour(x, y, channel));
  return linear;
}

}  // namespace

Image<float> errorOf(const SurfaceImage& surfaces, const Image<float>& reference) {
  Image<float> error(surfaces.width(), surfaces.height());
  for (int y = 0; y < surfaces.height(); ++y)
    for (int x = 0; x < surfaces.width(); ++x)
      if (surfaces.receivesShadow(x, y)) error(x, y) = surfaces.visibility(x, y) - reference(x, y);
  return error;
}

void FrameLayers::add(const Technique& technique, HeadlessFrame& frame) {
  const std::string prefix = std::string(technique.info().id) + ".";
  const Image<std::uint8_t> colour = frame.colour();
  const SurfaceImage surfaces = frame.surfaces();
  const Image<float> reference = frame.reference();
  constexpr std::array<const char*, 3> colours{"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    const Image<float> linear = linearChannel(colour, c);
    if (first_) file_.add(colours[c], linear);
    file_.add(prefix + colours[c], linear);
  }
  if (std::exchange(first_, false)) {
    file_.add("u", channelOf(surfaces.coded(), 0));
    file_.add("v", channelOf(surfaces.coded(), 1));
    file_.add("receiver", channelOf(surfaces.coded(), 2));
    file_.add("reference", reference);
  }
  file_.add(prefix + "visibility", channelOf(surfaces.coded(), 3));
  file_.add(prefix + "error", errorOf(surfaces, reference));
  file_.addParameters(technique);
}

}  // namespace umbra
