// What a shaded frame reads at a point of a surface, whether the frame shows the point or not: the
// shading pass's own sums, in double precision.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>
#include <vector>

#include "analysis/surfaces/SurfaceSpot.h"
#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/SurfacePoint.h"
#include "filters/core/scene/Camera.h"
#include "filters/core/settings/FrameSettings.h"

namespace umbra {

// The picture of a camera; pixels count from the top-left corner, whole ones are their corners.
struct PictureView {
  Camera camera;
  int width = 1, height = 1;  // pixels

  // None behind the camera; may be outside the picture.
  std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& world) const;
  Eigen::Vector3d rayThrough(const Eigen::Vector2d& pixel) const;  // world, from the camera
};

// What the frame was drawn with.
struct FrameView {
  PictureView picture;
  LightFrame light;  // of the whole light
  const std::vector<Cascade>& cascades;
  const FrameSettings& settings;
  double extent = 0.0;  // the diagonal of what bounds the light, world units
};

enum class Unreadable {
  OutsideMap,  // no part of the shadow map holds the point
  NotInSight,  // the read is as wide as the pixel, and the camera has none for the point
};

// As the shading pass reads it, without a visibility. A sheet is lit on the side that the camera
// sees.
std::variant<SurfacePoint, Unreadable> readOfSurface(const SurfaceSpot& spot,
                                                     const FrameView& frame);

// Whether the surface that a picture shows in the pixel of `point` is the one on which the point
// lies, with that normal: no farther away than a plane reaches in a pixel and a depth may err.
bool isSeenAt(const PictureView& picture, const Eigen::Vector3d& point,
              const Eigen::Vector3d& normal, const Eigen::Vector3d& shown);
// Whether it is the very point, to a hundredth of a pixel: what the picture knows of its pixel then
// holds for the point.
bool isShownAt(const PictureView& picture, const Eigen::Vector3d& point,
               const Eigen::Vector3d& shown);

}  // namespace umbra
