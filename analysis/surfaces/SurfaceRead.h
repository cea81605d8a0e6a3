// Computes what a shaded frame reads at a point of a surface, whether the frame shows the point or
// not. It repeats the shading pass's calculation in double precision.
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

// The picture of a camera. Pixel coordinates count from the top-left corner; whole numbers are
// corners of pixels.
struct PictureView {
  Camera camera;
  int width = 1, height = 1;  // pixels

  // Empty behind the camera. The result may lie outside the picture.
  std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& world) const;
  Eigen::Vector3d rayThrough(const Eigen::Vector2d& pixel) const;  // world, from the camera
};

// The settings that the frame was drawn with.
struct FrameView {
  PictureView picture;
  LightFrame light;  // the whole light's
  const std::vector<Cascade>& cascades;
  const FrameSettings& settings;
  double extent = 0.0;  // the diagonal of the bounds that the light's frame holds, world units
};

enum class Unreadable {
  OutsideMap,  // no part of the shadow map holds the point
  NotInSight,  // the read is as wide as the pixel, and the camera has no pixel for the point
};

// The read of the shading pass, without a visibility. A sheet is lit on the side that the camera
// sees.
std::variant<SurfacePoint, Unreadable> readOfSurface(const SurfaceSpot& spot,
                                                     const FrameView& frame);

// Whether the surface that a picture shows in the pixel of `point` is the one on which the point
// lies, with that normal: their distance is at most that which a plane spans in a pixel plus the
// error of a depth.
bool isSeenAt(const PictureView& picture, const Eigen::Vector3d& point,
              const Eigen::Vector3d& normal, const Eigen::Vector3d& shown);
// Whether the picture shows the point itself, to a hundredth of a pixel: what the picture knows of
// its pixel is then true for the point.
bool isShownAt(const PictureView& picture, const Eigen::Vector3d& point,
               const Eigen::Vector3d& shown);

}  // namespace umbra
