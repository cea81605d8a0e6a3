#include "ui/panes/PaneFigures.h"

#include "ui/panes/PanePictures.h"
#include "ui/panes/ShownPanes.h"
#include "ui/picture/ProbeReport.h"
#include "ui/picture/SceneView.h"
#include "ui/session/SessionController.h"

namespace umbra {

std::optional<PaneFigures> figuresOf(const ShownPane& pane, const DrawnPane* drawn,
                                     const ProbeReport& report, const SessionController& controller,
                                     SceneView& view) {
  const Session& session = controller.session();
  if (isSetAsActive(pane, controller)) {
    const TechniqueResult* result = resultOf(report.probe, pane.session.technique);
    if (!result) return std::nullopt;
    return PaneFigures{*result, report.probe.reference, session.frame.kernel, {}};
  }
  if (!drawn || drawn->picture.isNull() || !report.inSight) return std::nullopt;
  const FrameEvidence& evidence = drawn->evidence;
  const auto mapOf = [&](int cascade) -> const DepthMap& {
    return evidence.maps.empty() ? view.lastFrame()->depthMap(cascade)
                                 : evidence.maps[std::size_t(cascade)];
  };
  const std::optional<FrameProbe> probe = probeFrame(evidence, drawn->subject.frame, mapOf,
                                                     report.pixel, session.receiver, report.plane);
  if (!probe || probe->probe.techniques.empty()) return std::nullopt;
  return PaneFigures{probe->probe.techniques.front(), probe->probe.reference,
                     drawn->subject.frame.kernel, probe->footprint};
}

}  // namespace umbra
