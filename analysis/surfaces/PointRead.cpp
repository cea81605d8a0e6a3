#include "analysis/surfaces/PointRead.h"

#include <cmath>

namespace umbra {

std::optional<SeenPoint> seenPoint(const Eigen::Vector3d& point, const SurfaceSpot& spot,
                                   const PictureView& picture, const ShownAt& shownAt) {
  const auto at = picture.pixelOf(point);
  if (!at || at->minCoeff() < 0.0 || at->x() >= picture.width || at->y() >= picture.height)
    return std::nullopt;
  SeenPoint seen{int(at->x()), int(at->y()), {}};
  const auto shown = shownAt(seen.x, seen.y);
  if (!shown || !isSeenAt(picture, point, spot.normal, shown->world)) return std::nullopt;
  seen.shown = *shown;
  seen.isPoint = shown->isInMap() && isShownAt(picture, point, shown->world);
  return seen;
}

std::variant<PointRead, NotRead> readOfPoint(const Eigen::Vector3d& point,
                                             const std::optional<SurfaceSpot>& spot,
                                             const FrameView& frame,
                                             const std::optional<SeenPoint>& seen) {
  if (!spot) return NotRead::NoSurface;
  if (seen && seen->isPoint) return PointRead{seen->shown, seen, true};
  const auto found = readOfSurface(*spot, frame);
  if (const auto* why = std::get_if<Unreadable>(&found))
    return *why == Unreadable::OutsideMap ? NotRead::OutsideMap : NotRead::NotInSight;
  PointRead read{std::get<SurfacePoint>(found), seen};
  read.surface.world = point;
  return read;
}

}  // namespace umbra
