#include "ui/probe/HeldPoint.h"

#include "ui/picture/SceneView.h"
#include "ui/session/Document.h"

namespace umbra {
namespace {

PictureView pictureOf(const SceneView& view) {
  return {view.lastFrame()->camera(), view.pixels().width(), view.pixels().height()};
}

FrameSettings readsOf(FrameSettings frame) {
  frame.view = ViewMode::Shaded;  // what is shown changes no read
  return frame;
}

// What is read of a map: how wide, and which one.
bool dependsOnCamera(const FrameSettings& frame) {
  return frame.read.filter > ReadFilter::Bilinear || frame.map.cascades.count > 1;
}

}  // namespace

std::optional<SurfacePlace> placeAt(SceneView& view, const Pixel& pixel) {
  const auto surface = view.surfaceAt(pixel);
  if (!surface || !surface->isInMap()) return std::nullopt;
  return SurfacePlace{pixel, *surface, view.surfacePlane(pixel, *surface)};
}

HeldPoint::HeldPoint(const SurfacePlace& place, const SceneView& view, const Document& document)
    : point_(place.surface.world) {
  remember(place, view, document);
}

void HeldPoint::remember(const SurfacePlace& place, const SceneView& view,
                         const Document& document) {
  lastShown_ = place;
  map_ = view.mapRevision();
  frame_ = readsOf(document.session.frame);
}

// Looked for once per scene: a scene may have a million triangles.
const std::optional<SurfaceSpot>& HeldPoint::spotIn(const Document& document) {
  if (scene_ != document.content.scene) {
    scene_ = document.content.scene;
    spot_ = scene_ ? surfaceNear(*scene_, point_) : std::nullopt;
  }
  return spot_;
}

std::string HeldPoint::objectName(const Document& document) {
  const auto& spot = spotIn(document);
  return spot ? scene_->objects[spot->object].name : std::string();
}

bool HeldPoint::remembers(const SceneView& view, const Document& document) const {
  return lastShown_ && map_ == view.mapRevision() && frame_ == readsOf(document.session.frame);
}

std::variant<SurfacePlace, NotRead> HeldPoint::find(SceneView& view, const Document& document) {
  const std::optional<SurfacePlace> seen = visible(view, document);
  if (seen && isShownAt(pictureOf(view), point_, seen->surface.world)) {
    remember(*seen, view, document);
    return *seen;
  }
  std::variant<SurfacePlace, NotRead> found = NotRead::NoSurface;
  if (remembers(view, document) && !(seen && dependsOnCamera(document.session.frame)))
    found = *lastShown_;
  else
    found = computed(view, document);
  if (auto* place = std::get_if<SurfacePlace>(&found)) {
    place->inSight = seen.has_value();
    place->asShown = false;
    if (seen) place->pixel = seen->pixel;
  }
  return found;
}

std::optional<SurfacePlace> HeldPoint::visible(SceneView& view, const Document& document) {
  const std::optional<Pixel> pixel = view.pixelOf(point_);
  const auto& spot = spotIn(document);
  if (!pixel || !spot) return std::nullopt;
  auto place = placeAt(view, *pixel);
  if (!place || !isSeenAt(pictureOf(view), point_, spot->normal, place->surface.world))
    return std::nullopt;  // something stands in front of the point
  return place;
}

std::variant<SurfacePlace, NotRead> HeldPoint::computed(const SceneView& view,
                                                        const Document& document) {
  const auto& spot = spotIn(document);
  if (!spot) return NotRead::NoSurface;
  const ShadowRenderer& drawn = *view.lastFrame();
  const double extent = document.content.scene->lightBounds().diagonal().norm();
  const auto found = readOfSurface(*spot, {pictureOf(view), drawn.lightFrame(), drawn.cascades(),
                                           document.session.frame, extent});
  if (const auto* why = std::get_if<Unreadable>(&found))
    return *why == Unreadable::OutsideMap ? NotRead::OutsideMap : NotRead::NotInSight;
  SurfacePlace place;
  place.plane = Plane(spot->normal, spot->point);
  place.pixel = lastShown_ ? lastShown_->pixel : document.session.probe.value_or(Pixel{});
  place.surface = std::get<SurfacePoint>(found);
  place.surface.world = point_;
  return place;
}

}  // namespace umbra
