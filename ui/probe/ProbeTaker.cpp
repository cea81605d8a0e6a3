#include "ui/probe/ProbeTaker.h"

#include "analysis/frame/DrawnFrame.h"
#include "ui/picture/SceneView.h"
#include "ui/session/SessionController.h"

namespace umbra {

ProbeTaker::ProbeTaker(SessionController& controller, SceneView& view)
    : controller_(controller), view_(view) {}

void ProbeTaker::sessionChanged(const Document& before, const Document& after) {
  const Session &old = before.session, &now = after.session;
  if (!(before.content == after.content) || old.technique != now.technique ||
      !(old.parameters == now.parameters) || old.frame.map.format != now.frame.map.format)
    adaptedTo_ = -1;
}

ProbeReport ProbeTaker::at(const SurfacePlace& place, const std::optional<double>& receiver) {
  ShadowRenderer& frame = *view_.lastFrame();
  const Session& session = controller_.session();
  const SurfacePoint& surface = place.surface;
  const std::vector<Cascade>& cascades = frame.cascades();
  ProbeRequest request = requestOf(
      session.frame, cascades,
      [&](int cascade) -> const DepthMap& { return frame.depthMap(cascade); }, surface);
  request.receiver = receiver.value_or(surface.receiver);
  ProbeReport report = probe(std::move(request), frame.depthMap(0), view_.firstMapRevision());
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
  const DepthMap& map = *controller_.document().content.depth;
  if (texel.x < 0 || texel.y < 0 || texel.x >= map.width() || texel.y >= map.height())
    return std::nullopt;
  ProbeRequest request =
      requestOf(controller_.session().frame, {}, [&](int) -> const DepthMap& { return map; }, {});
  request.read = ReadPoint::atTexel(map, texel.x, texel.y);
  request.receiver = receiver.value_or(0.5);
  ProbeReport report = probe(std::move(request), map, 0);
  report.pixel = texel;
  return report;
}

// The picture's technique takes the picture's splits, so that both agree while they move.
void ProbeTaker::adaptTechniques(const DepthMap& map, int revision) {
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

ProbeReport ProbeTaker::probe(ProbeRequest request, const DepthMap& first, int revision) {
  adaptTechniques(first, revision);
  request.techniques = adapted_;
  ProbeReport report;
  report.probe = takeProbe(request);
  report.request = std::make_shared<const ProbeRequest>(std::move(request));
  return report;
}

}  // namespace umbra
