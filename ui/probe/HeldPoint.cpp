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
  maps_ = view.baked().maps;
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
  return lastShown_ && maps_ == view.baked().maps && frame_ == readsOf(document.session.frame);
}

std::variant<SurfacePlace, NotRead> HeldPoint::find(SceneView& view, const Document& document) {
  const auto& spot = spotIn(document);
  if (!spot) return NotRead::NoSurface;
  const PictureView picture = pictureOf(view);
  const std::optional<SeenPoint> seen = seenPoint(point_, *spot, picture, [&view](int x, int y) {
    return view.surfaceAt({x, y});
  });
  const bool shown = seen && seen->isPoint;
  SurfacePlace place;
  if (!shown && remembers(view, document) && !(seen && dependsOnCamera(document.session.frame))) {
    place = *lastShown_;
  } else {
    const ShadowRenderer& drawn = *view.lastFrame();
    const double extent = document.content.scene->lightBounds().diagonal().norm();
    const auto found = readOfPoint(
        point_, spot,
        {picture, drawn.lightFrame(), drawn.cascades(), document.session.frame, extent}, seen);
    if (const auto* why = std::get_if<NotRead>(&found)) return *why;
    place.surface = std::get<PointRead>(found).surface;
    place.plane = Plane(spot->normal, spot->point);
    place.pixel = lastShown_ ? lastShown_->pixel : document.session.probe.value_or(Pixel{});
  }
  place.inSight = seen.has_value();
  place.asShown = shown;
  if (seen) place.pixel = {seen->x, seen->y};
  if (!shown) return place;
  place.plane = view.surfacePlane(place.pixel, place.surface);
  remember(place, view, document);
  return place;
}

}  // namespace umbra
