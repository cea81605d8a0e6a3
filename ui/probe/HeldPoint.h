// A point of a surface that is read frame by frame, in sight or not.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>

#include "analysis/surfaces/PointRead.h"
#include "filters/gpu/ShadowRenderer.h"
#include "ui/picture/Footprint.h"
#include "ui/picture/ProbeReport.h"

namespace umbra {

class SceneView;
struct Document;

// Where a frame reads a surface.
struct SurfacePlace {
  Pixel pixel;  // of the view; of a hidden point where it was last seen, or would be
  SurfacePoint surface;
  std::optional<Plane> plane;  // around it
  bool inSight = true;         // else the frame has no pixel of it
  bool asShown = true;         // the surface is a pixel's own, with its visibility
};

// What the last frame shows at a pixel of the view; none in the sky and outside the shadow map.
std::optional<SurfacePlace> placeAt(SceneView& view, const Pixel& pixel);

class HeldPoint {
 public:
  explicit HeldPoint(const Eigen::Vector3d& point) : point_(point) {}
  // A place of the last frame.
  HeldPoint(const SurfacePlace& place, const SceneView& view, const Document& document);

  const Eigen::Vector3d& point() const { return point_; }  // world

  // Where the last frame reads it, by readOfPoint; but where a pixel showed the very point before
  // and nothing but the camera has changed since, what was read there goes on to be read, so that
  // the figures stay those of a picture.
  std::variant<SurfacePlace, NotRead> find(SceneView& view, const Document& document);
  // Names the object that the point lies on, in a scene that has been drawn; "" where it lies on
  // none.
  std::string objectName(const Document& document);

 private:
  const std::optional<SurfaceSpot>& spotIn(const Document& document);
  bool remembers(const SceneView& view, const Document& document) const;
  void remember(const SurfacePlace& place, const SceneView& view, const Document& document);

  Eigen::Vector3d point_;
  std::shared_ptr<const Scene> scene_;  // of spot_
  std::optional<SurfaceSpot> spot_;
  // As it was last shown, and what its read depended on beside the camera.
  std::optional<SurfacePlace> lastShown_;
  std::shared_ptr<const void> maps_;  // Baked::maps
  FrameSettings frame_;
};

}  // namespace umbra
