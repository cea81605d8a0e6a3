// What a drawn frame knows of the surface in each of its pixels.
#pragma once

#include <optional>

#include "filters/core/maps/Image.h"
#include "filters/core/maps/SurfacePoint.h"

namespace umbra {

// Holds the two images that the shading pass writes. No other C++ knows how they are coded; the
// shading pass's GLSL has its own decoder in Surface.glsl.
class SurfaceImage {
 public:
  SurfaceImage() = default;
  // Pixels without a surface, for set() to fill. Footprints and cascades are kept only `wide`.
  SurfaceImage(int width, int height, bool wide = false);
  // As the shading pass writes them, four channels each. `surfaces` has u, v, z_r and visibility: a
  // negative u says that there is no surface, and the sign bit of z_r, also of a zero, that the
  // surface faces away from the light. `footprints` has x, y and probes of the footprint, then the
  // cascade plus the weight of the next one; it is empty where the reads have neither.
  SurfaceImage(Image<float> surfaces, Image<float> footprints);

  int width() const { return surfaces_.width(); }
  int height() const { return surfaces_.height(); }
  bool empty() const { return surfaces_.empty(); }
  // Whether pixels have footprints and cascades of their own.
  bool wide() const { return !footprints_.empty(); }

  // Whether the pixel is inside the image and shows a surface.
  bool shows(int x, int y) const;
  // What it shows there, without the place in the world; none where shows() says no.
  std::optional<SurfacePoint> at(int x, int y) const;
  void set(int x, int y, const SurfacePoint& surface);

  // The three of at() that are asked for in every pixel, of a pixel inside the image: as the GPU
  // computed it, 1 without a surface; z_r, 0 without a surface; SurfacePoint::receivesShadow().
  float visibility(int x, int y) const { return surfaces_(x, y, 3); }
  float receiver(int x, int y) const;
  bool receivesShadow(int x, int y) const;

  // u, v, z_r and visibility as they are coded, for the files that hold them so.
  const Image<float>& coded() const { return surfaces_; }

  bool operator==(const SurfaceImage&) const = default;

 private:
  SurfacePoint decoded(int x, int y) const;

  Image<float> surfaces_, footprints_;
};

}  // namespace umbra
