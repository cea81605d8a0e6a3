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

void addColours(ChannelFile& file, const std::string& prefix, const Image<std::uint8_t>& colour) {
  constexpr std::array<const char*, 3> names{"R", "G", "B"};
  for (int c = 0; c < 3; ++c) file.add(prefix + names[c], linearChannel(colour, c));
}

void addSurfaces(ChannelFile& file, const SurfaceImage& surfaces, const Image<float>& reference) {
  file.add("u", channelOf(surfaces.coded(), 0));
  file.add("v", channelOf(surfaces.coded(), 1));
  file.add("receiver", channelOf(surfaces.coded(), 2));
  file.add("reference", reference);
}

void addVisibility(ChannelFile& file, const std::string& prefix, const SurfaceImage& surfaces,
                   const Image<float>& reference) {
  file.add(prefix + "visibility", channelOf(surfaces.coded(), 3));
  file.add(prefix + "error", errorOf(surfaces, reference));
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
  const bool first = std::exchange(first_, false);
  const Image<std::uint8_t> colour = frame.colour();
  const SurfaceImage surfaces = frame.surfaces();
  const Image<float> reference = frame.reference();
  if (first) addColours(file_, "", colour);
  addColours(file_, prefix, colour);
  if (first) addSurfaces(file_, surfaces, reference);
  addVisibility(file_, prefix, surfaces, reference);
  file_.addParameters(technique);
}

ExrPart partOf(const Drawing& pane, HeadlessFrame& frame) {
  ChannelFile file(pane.session);
  const SurfaceImage surfaces = frame.surfaces();
  const Image<float> reference = frame.reference();
  addColours(file, "", frame.colour());
  addSurfaces(file, surfaces, reference);
  addVisibility(file, "", surfaces, reference);
  file.addParameters(*pane.technique);
  file.note("umbrascope.pane", pane.label);
  return file.part(pane.name);
}

}  // namespace umbra
