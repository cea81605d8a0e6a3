#include "ui/HeldPoint.h"

#include "ui/Document.h"
#include "ui/SceneView.h"

namespace umbra {
namespace {

PictureView pictureOf(const SceneView& view) {
  return {view.lastFrame()->camera(), view.pixels().width(), view.pixels().height()};
}

FrameSettings readsOf(FrameSettings frame) {
  frame.view = ViewMode::Shaded;  // what is shown changes no read
  return frame;
}

}  // namespace

std::optional<SurfacePlace> placeAt(SceneView& view, const Pixel& pixel) {
  const auto surface = view.surfaceAt(pixel);
  if (!surface || surface->u < 0.0 || surface->u > 1.0 || surface->v < 0.0 || surface->v > 1.0)
    return std::nullopt;
  return SurfacePlace{pixel, *surface, view.surfacePlane(pixel, *surface)};
}

HeldPoint::HeldPoint(const SurfacePlace& place, const SceneView& view, const Document& document)
    : point_(place.surface.world) {
  remember(place, view, document);
}

void HeldPoint::remember(const SurfacePlace& place, const SceneView& view,
                         const Document& document) {
  lastSeen_ = place;
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

std::variant<SurfacePlace, NotRead> HeldPoint::find(SceneView& view, const Document& document) {
  if (auto place = visible(view, document)) {
    remember(*place, view, document);
    return *place;
  }
  return hidden(view, document);
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

std::variant<SurfacePlace, NotRead> HeldPoint::hidden(const SceneView& view,
                                                      const Document& document) {
  const FrameSettings& frame = document.session.frame;
  if (lastSeen_ && map_ == view.mapRevision() && frame_ == readsOf(frame)) {
    SurfacePlace place = *lastSeen_;
    place.inSight = false;
    return place;
  }
  const auto& spot = spotIn(document);
  if (!spot) return NotRead::NoSurface;
  const ShadowRenderer& drawn = *view.lastFrame();
  const auto found = readOfSurface(point_, spot->normal,
                                   {pictureOf(view), drawn.lightFrame(), drawn.cascades(), frame,
                                    document.content.scene->lightBounds().diagonal().norm()});
  if (const auto* why = std::get_if<Unreadable>(&found))
    return *why == Unreadable::OutsideMap ? NotRead::OutsideMap : NotRead::NotInSight;
  const auto& read = std::get<SurfaceRead>(found);
  SurfacePlace place;
  place.inSight = false;
  place.plane = Plane(spot->normal, point_);
  place.pixel = lastSeen_ ? lastSeen_->pixel : document.session.probe.value_or(Pixel{});
  SurfacePoint& surface = place.surface;
  surface.u = read.read.u;
  surface.v = read.read.v;
  surface.footprint = read.read.footprint;
  surface.receiver = read.receiver;
  surface.facesLight = read.facesLight;
  surface.world = point_;
  surface.cascade = read.cascade;
  surface.nextCascade = read.nextCascade;
  return place;
}

}  // namespace umbra
