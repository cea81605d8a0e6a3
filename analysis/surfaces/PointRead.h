// Where a drawn frame reads a point of a surface, in sight or not: for the pinned and the kept
// probes of the window and for those of the command line.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <variant>

#include "analysis/surfaces/SurfaceRead.h"
#include "analysis/surfaces/SurfaceSpot.h"

namespace umbra {

// What a picture shows in a pixel, with its place in the world; none in the sky and outside.
using ShownAt = std::function<std::optional<SurfacePoint>(int x, int y)>;

// The pixel in which a picture shows a point.
struct SeenPoint {
  int x = 0, y = 0;
  SurfacePoint shown;  // in the middle of the pixel: on the point's surface, near the point
  // It is the very point and on the map, so that the figures of the pixel are those of the point.
  bool isPoint = false;
};

// None where the point is out of the picture or something stands in front. `spot` is the surface
// that the point lies on.
std::optional<SeenPoint> seenPoint(const Eigen::Vector3d& point, const SurfaceSpot& spot,
                                   const PictureView& picture, const ShownAt& shownAt);

enum class NotRead { NoSurface, OutsideMap, NotInSight };

struct PointRead {
  SurfacePoint surface;
  std::optional<SeenPoint> seen;  // none where the point is hidden from the camera
  bool asShown = false;  // the surface is its pixel's own, with the visibility that the frame has
};

// What the frame reads in the pixel whose middle shows the point, so that the figures are those of
// the picture; else what it would read, were the point the middle of a pixel and nothing in front.
// `spot` is none for a point that lies on no surface; `seen` is what seenPoint tells of it.
std::variant<PointRead, NotRead> readOfPoint(const Eigen::Vector3d& point,
                                             const std::optional<SurfaceSpot>& spot,
                                             const FrameView& frame,
                                             const std::optional<SeenPoint>& seen);

}  // namespace umbra
