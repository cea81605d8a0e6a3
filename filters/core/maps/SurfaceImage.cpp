#include "filters/core/maps/SurfaceImage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace umbra {
namespace {

constexpr float nothing[] = {-1.0F, -1.0F, 0.0F, 1.0F};  // of a pixel without a surface
constexpr float onePoint[] = {0.0F, 0.0F, 1.0F, 0.0F};   // of a read without a footprint

}  // namespace

SurfaceImage::SurfaceImage(int width, int height, bool wide)
    : surfaces_(width, height, 4),
      footprints_(wide ? Image<float>(width, height, 4) : Image<float>()) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::ranges::copy(nothing, surfaces_.pixel(x, y).begin());
      if (wide) std::ranges::copy(onePoint, footprints_.pixel(x, y).begin());
    }
}

SurfaceImage::SurfaceImage(Image<float> surfaces, Image<float> footprints)
    : surfaces_(std::move(surfaces)), footprints_(std::move(footprints)) {}

bool SurfaceImage::shows(int x, int y) const {
  return x >= 0 && y >= 0 && x < width() && y < height() && surfaces_(x, y, 0) >= 0.0F;
}

std::optional<SurfacePoint> SurfaceImage::at(int x, int y) const {
  if (!shows(x, y)) return std::nullopt;
  return decoded(x, y);
}

SurfacePoint SurfaceImage::decoded(int x, int y) const {
  const auto values = surfaces_.pixel(x, y);
  SurfacePoint surface;
  surface.u = values[0];
  surface.v = values[1];
  surface.receiver = std::abs(values[2]);
  surface.visibility = values[3];
  surface.facesLight = !std::signbit(values[2]);
  if (footprints_.empty()) return surface;
  const auto footprint = footprints_.pixel(x, y);
  surface.footprint = {footprint[0], footprint[1], int(footprint[2])};
  surface.cascade = int(footprint[3]);
  surface.nextCascade = footprint[3] - float(surface.cascade);
  return surface;
}

void SurfaceImage::set(int x, int y, const SurfacePoint& surface) {
  const float receiver = float(surface.receiver);
  const float values[] = {float(surface.u), float(surface.v),
                          std::copysign(receiver, surface.facesLight ? 1.0F : -1.0F),
                          float(surface.visibility)};
  std::ranges::copy(values, surfaces_.pixel(x, y).begin());
  if (footprints_.empty()) return;
  const float footprint[] = {float(surface.footprint.x), float(surface.footprint.y),
                             float(surface.footprint.probes),
                             float(surface.cascade + surface.nextCascade)};
  std::ranges::copy(footprint, footprints_.pixel(x, y).begin());
}

float SurfaceImage::receiver(int x, int y) const {
  return std::abs(surfaces_(x, y, 2));
}

bool SurfaceImage::receivesShadow(int x, int y) const {
  return shows(x, y) && decoded(x, y).receivesShadow();
}

}  // namespace umbra
