#include "ui/Prober.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "analysis/WorstPixel.h"
#include "ui/SceneView.h"
#include "ui/SessionController.h"

namespace umbra {
namespace {

// A pixel of a picture of the session's size in one of another size: the camera keeps its vertical
// angle, so that both centres show the same point and lengths follow the height.
Pixel scaledPixel(const Pixel& pixel, const Session& session, const QSize& to) {
  const double scale = double(to.height()) / session.height;
  const auto along = [scale](int value, int from, int size) {
    return int(std::floor((value + 0.5 - from / 2.0) * scale + size / 2.0));
  };
  return {along(pixel.x, session.width, to.width()), along(pixel.y, session.height, to.height())};
}

}  // namespace

Prober::Prober(SessionController& controller, SceneView& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view) {
  connect(&view_, &SceneView::frameDrawn, this, &Prober::refresh);
  connect(&view_, &SceneView::hovered, this, &Prober::hover);
  connect(&view_, &SceneView::clicked, this, &Prober::pin);
  connect(&controller_, &SessionController::changed, this, &Prober::sessionChanged);
}

void Prober::sessionChanged(const Document& before, const Document& after) {
  const Session &old = before.session, &now = after.session;
  if (!(before.content == after.content) || old.technique != now.technique ||
      !(old.parameters == now.parameters) || old.frame.map.format != now.frame.map.format)
    adaptedTo_ = -1;
  if (!(before.session.probe == after.session.probe)) {
    pinnedPoint_.reset();
    if (after.session.probe) lastSeen_.reset();
  }
  if (!(before.content == after.content)) {
    hover_.reset();
    pinnedPoint_.reset();
    lastSeen_.reset();
    report_.reset();
    emit reported();
  }
  if (after.content.depth) refresh();  // a scene is probed after the frame that follows
}

void Prober::setVeil(const QString& reason) {
  if (reason == veil_) return;
  veil_ = reason;
  // A report refers to maps that are there only while it is announced: what is seen again is taken
  // again.
  if (reason.isEmpty())
    refresh();
  else
    emit reported();
}

void Prober::hover(const Pixel& pixel) {
  if (controller_.session().probe) return;
  hover_ = pixel;
  refresh();
}

void Prober::pin(const Pixel& pixel) {
  const bool onScene = controller_.document().content.scene != nullptr;
  if (onScene && !view_.surfaceAt(pixel)) return;  // the sky has no shadow to take apart
  const QSize size = view_.pixels();
  controller_.edit(tr("Pin probe"), [&](Session& session) {
    session.probe = pixel;
    if (!onScene) return;
    session.width = size.width();
    session.height = size.height();
    session.receiver.reset();
  });
  refresh();
}

void Prober::unpin() {
  hover_.reset();
  controller_.edit(tr("Unpin probe"), [](Session& session) {
    session.probe.reset();
    session.receiver.reset();
  });
  refresh();
}

void Prober::pinWorstBleeding() {
  ShadowRenderer* frame = view_.lastFrame();
  if (!frame) return;
  try {
    const auto worst = worstBleeding(frame->surfaces(), frame->reference());
    if (!worst) return;
    const QSize size = view_.pixels();
    controller_.amend([&](Session& session) {
      session.probe = Pixel{worst->x, worst->y};
      session.width = size.width();
      session.height = size.height();
    });
    refresh();
  } catch (const std::exception& problem) {
    emit failed(QString::fromUtf8(problem.what()));
  }
}

void Prober::refresh() {
  try {
    report_ = take();
    emit reported();
  } catch (const std::exception& problem) {
    report_.reset();  // of settings that are gone
    emit reported();
    emit failed(QString::fromUtf8(problem.what()));
  }
}

std::optional<ProbeReport> Prober::take() {
  return controller_.document().content.depth ? takeOnDepthFile() : takeOnScene();
}

// Keeps a pinned probe on its point of the surface while the camera moves.
std::optional<Pixel> Prober::pinnedPixel() {
  const Session& session = controller_.session();
  if (pinnedPoint_) return view_.pixelOf(*pinnedPoint_);
  return scaledPixel(*session.probe, session, view_.pixels());
}

std::optional<ProbeReport> Prober::takeOnScene() {
  if (!view_.lastFrame() || (!controller_.session().probe && !hover_)) return std::nullopt;
  if (const auto place = visiblePlace()) {
    lastSeen_ = place;
    return probeAt(*place);
  }
  // What was last in sight stays to be read, with what is now set: the map is there to be read.
  const auto place = hiddenPlace();
  return place ? std::optional(probeAt(*place)) : std::nullopt;
}

std::optional<Prober::Place> Prober::visiblePlace() {
  const bool pinned = controller_.session().probe.has_value();
  const std::optional<Pixel> pixel = pinned ? pinnedPixel() : hover_;
  const auto surface = pixel ? view_.surfaceAt(*pixel) : std::nullopt;
  if (!surface || surface->u < 0.0 || surface->u > 1.0 || surface->v < 0.0 || surface->v > 1.0)
    return std::nullopt;
  if (pinned && pinnedPoint_ && lastSeen_ &&
      (surface->world - *pinnedPoint_).norm() > 0.05 * (1.0 + pinnedPoint_->norm()))
    return std::nullopt;  // something stands in front of the point now
  if (pinned && !pinnedPoint_) pinnedPoint_ = surface->world;
  return Place{*pixel,
               *surface,
               view_.surfacePlane(*pixel, *surface),
               view_.lastFrame()->lightFrame().project(surface->world).z,
               view_.mapRevision(),
               true,
               controller_.session().frame.read.filter};
}

std::optional<Prober::Place> Prober::hiddenPlace() {
  if (!lastSeen_) return std::nullopt;
  Place place = *lastSeen_;
  place.inSight = false;
  const FrameSettings& frame = controller_.session().frame;
  if (frame.read.filter == ReadFilter::SummedArea) {
    const double least = 2.0 * frame.kernel.effectiveRadius() + 1.0;
    Footprint& box = place.surface.footprint;
    if (place.filter != frame.read.filter) box = {};
    box.x = std::max(box.x, least);
    box.y = std::max(box.y, least);
  } else if (place.filter != frame.read.filter && frame.read.filter > ReadFilter::Bilinear) {
    return std::nullopt;  // nobody knows what the hidden pixel would cover
  }
  if (place.map == view_.mapRevision()) return place;
  // The light has moved: the point is elsewhere in its map, as far in front of itself as before.
  const LightPoint point = view_.lastFrame()->lightFrame().project(place.surface.world);
  if (!point.inside) return std::nullopt;
  const std::vector<Cascade>& cascades = view_.lastFrame()->cascades();
  SurfacePoint& surface = place.surface;
  surface.nextCascade = 0.0;
  surface.receiver = std::clamp(point.z + surface.receiver - place.depth, 0.0, 1.0);
  // Windows move with the camera: a coarser one may hold it now.
  surface.cascade = std::min(surface.cascade, int(cascades.size()) - 1);
  for (; surface.cascade < int(cascades.size()); ++surface.cascade) {
    surface.u = cascades[surface.cascade].u(point.u);
    surface.v = cascades[surface.cascade].v(point.v);
    if (surface.u >= 0.0 && surface.u <= 1.0 && surface.v >= 0.0 && surface.v <= 1.0) return place;
  }
  return std::nullopt;
}

ProbeReport Prober::probeAt(const Place& place) {
  ShadowRenderer& frame = *view_.lastFrame();
  const Session& session = controller_.session();
  const SurfacePoint& surface = place.surface;
  const std::vector<Cascade>& cascades = frame.cascades();
  ProbeRequest request =
      requestOn(frame.depthMap(surface.cascade),
                {session.frame.read.filter, surface.u, surface.v, surface.footprint},
                session.receiver.value_or(surface.receiver));
  request.cascade = surface.cascade;
  if (surface.nextCascade > 0.0) {
    const int next = surface.cascade + 1;
    request.seam.emplace(SeamPart{
        frame.depthMap(next),
        readInCascade(request.read, cascades[surface.cascade], cascades[next], request.kernel),
        surface.nextCascade});
  }
  ProbeReport report = probe(std::move(request), frame.depthMap(0), view_.firstMapRevision());
  report.cascade = surface.cascade;
  report.pixel = place.pixel;
  report.pinned = session.probe.has_value();
  report.facesLight = surface.facesLight;
  report.receiverByHand = session.receiver.has_value();
  report.point = surface.world;
  report.footprint = footprintOf(ownRegion(report.probe), session.frame.map.size, surface.receiver,
                                 cascades[surface.cascade].frame, place.plane);
  if (session.receiver || !place.inSight) return report;  // the frame shows no such visibility
  for (TechniqueResult& result : report.probe.techniques)
    if (result.technique->info().id == session.technique) result.gpu = surface.visibility;
  return report;
}

std::optional<ProbeReport> Prober::takeOnDepthFile() {
  const Document& document = controller_.document();
  const DepthMap& map = *document.content.depth;
  const std::optional<Pixel> texel = document.session.probe ? document.session.probe : hover_;
  if (!texel || texel->x < 0 || texel->y < 0 || texel->x >= map.width() || texel->y >= map.height())
    return std::nullopt;
  ProbeReport report = probe(requestOn(map, ReadPoint::atTexel(map, texel->x, texel->y),
                                       document.session.receiver.value_or(0.5)),
                             map, 0);
  report.pixel = *texel;
  report.pinned = document.session.probe.has_value();
  return report;
}

// The picture's technique takes the picture's splits, so that both agree while they move.
void Prober::adaptTechniques(const DepthMap& map, int revision) {
  const ShadowRenderer* frame = view_.lastFrame();
  std::vector<double> splits;
  if (frame && controller_.document().content.scene) splits = frame->adaptedSplits();
  const auto shown = [&](const Technique& technique) {
    return !splits.empty() && technique.info().id == controller_.session().technique;
  };
  if (adaptedTo_ != revision) {
    adapted_.clear();
    for (const auto& technique : controller_.techniques()) {
      std::shared_ptr<Technique> copy = technique->clone();
      if (shown(*copy))
        copy->setAdaptedSplits(splits);
      else
        copy->adapt(map);
      adapted_.push_back(std::move(copy));
    }
  } else if (splits != splits_) {
    for (auto& technique : adapted_) {
      if (!shown(*technique)) continue;
      std::shared_ptr<Technique> copy = technique->clone();
      copy->setAdaptedSplits(splits);
      technique = std::move(copy);
    }
  }
  adaptedTo_ = revision;
  splits_ = std::move(splits);
}

ProbeRequest Prober::requestOn(const DepthMap& map, const ReadPoint& read, double receiver) const {
  const FrameSettings& settings = controller_.session().frame;
  return {.map = map,
          .read = read,
          .kernel = settings.kernel,
          .format = settings.map.format,
          .receiver = receiver,
          .satPrecision = settings.read.satPrecision};
}

ProbeReport Prober::probe(ProbeRequest request, const DepthMap& first, int revision) {
  adaptTechniques(first, revision);
  request.techniques = adapted_;
  ProbeReport report;
  report.probe = takeProbe(request);
  report.request = std::make_shared<const ProbeRequest>(std::move(request));
  return report;
}

}  // namespace umbra
