#include "ui/probe/ProbeTaker.h"

#include <utility>

#include "analysis/frame/AdaptedTechnique.h"
#include "analysis/frame/FrameReads.h"
#include "ui/picture/SceneView.h"
#include "ui/session/SessionController.h"

namespace umbra {
namespace {

// A request with the maps that it refers to.
struct KeptRequest {
  KeptRequest(std::vector<std::shared_ptr<const DepthMap>> theMaps, ProbeRequest theRequest)
      : maps(std::move(theMaps)), request(std::move(theRequest)) {}

  std::vector<std::shared_ptr<const DepthMap>> maps;
  ProbeRequest request;
};

}  // namespace

ProbeTaker::ProbeTaker(SessionController& controller, SceneView& view)
    : controller_(controller), view_(view) {}

ProbeReport ProbeTaker::at(const SurfacePlace& place, const std::optional<double>& receiver) {
  ShadowRenderer& frame = *view_.lastFrame();
  const Session& session = controller_.session();
  const SurfacePoint& surface = place.surface;
  const std::vector<Cascade>& cascades = frame.cascades();
  std::vector<SharedMap> maps;
  const auto mapOf = [&](int cascade) -> const DepthMap& {
    return *maps.emplace_back(frame.sharedDepthMap(cascade));
  };
  ProbeRequest request = requestOf(session.frame, cascades, mapOf, surface);
  request.receiver = receiver.value_or(surface.receiver);
  ProbeReport report = probe(std::move(request), frame.sharedDepthMap(), std::move(maps));
  report.cascade = surface.cascade;
  report.pixel = place.pixel;
  report.facesLight = surface.facesLight;
  report.receiverByHand = receiver.has_value();
  report.inSight = place.inSight;
  report.point = surface.world;
  report.plane = place.plane;
  report.footprint = footprintOf(ownRegion(report.probe), session.frame.map.size, surface.receiver,
                                 cascades[surface.cascade].frame, place.plane);
  if (receiver || !place.asShown) return report;  // the frame shows no such visibility
  for (TechniqueResult& result : report.probe.techniques)
    if (result.technique->info().id == session.technique) result.gpu = surface.visibility;
  return report;
}

std::optional<ProbeReport> ProbeTaker::at(const Pixel& texel,
                                          const std::optional<double>& receiver) {
  const SharedMap& shared = controller_.document().content.depth;
  const DepthMap& map = *shared;
  if (texel.x < 0 || texel.y < 0 || texel.x >= map.width() || texel.y >= map.height())
    return std::nullopt;
  ProbeRequest request =
      requestOf(controller_.session().frame, {}, [&](int) -> const DepthMap& { return map; }, {});
  request.read = ReadPoint::atTexel(map, texel.x, texel.y);
  request.receiver = receiver.value_or(0.5);
  ProbeReport report = probe(std::move(request), shared, {shared});
  report.pixel = texel;
  return report;
}

void ProbeTaker::adaptTechniques(const SharedMap& map) {
  const ShadowRenderer* frame = view_.lastFrame();
  std::vector<double> drawn;
  if (frame && controller_.document().content.scene) drawn = frame->adaptedSplits();
  std::vector<Adapted> adapted;
  for (const auto& technique : controller_.techniques()) {
    const bool shown = technique->info().id == controller_.session().technique;
    Adapted next{technique, shown ? drawn : std::vector<double>(), nullptr};
    for (const Adapted& known : adapted_)
      if (map == adaptedTo_ && known.asSet == next.asSet && known.splits == next.splits)
        next.technique = known.technique;
    if (!next.technique) next.technique = adaptedTechnique(*technique, *map, next.splits);
    adapted.push_back(std::move(next));
  }
  adapted_ = std::move(adapted);
  adaptedTo_ = map;
}

ProbeReport ProbeTaker::probe(ProbeRequest request, const SharedMap& first,
                              std::vector<SharedMap> maps) {
  adaptTechniques(first);
  for (const Adapted& each : adapted_) request.techniques.push_back(each.technique);
  ProbeReport report;
  report.probe = takeProbe(request);
  const auto kept = std::make_shared<const KeptRequest>(std::move(maps), std::move(request));
  report.request = {kept, &kept->request};
  return report;
}

}  // namespace umbra
