#include "ui/panes/PaneFigures.h"

#include "ui/panes/PanePictures.h"
#include "ui/panes/ShownPanes.h"
#include "ui/picture/FrameProbe.h"
#include "ui/picture/ProbeReport.h"
#include "ui/session/SessionController.h"

namespace umbra {

std::optional<PaneFigures> figuresOf(const ShownPane& pane, const DrawnPane* drawn,
                                     const ProbeReport& report,
                                     const SessionController& controller) {
  const Session& session = controller.session();
  if (isSetAsActive(pane, controller)) {
    const TechniqueResult* result = resultOf(report.probe, pane.session.technique);
    if (!result) return std::nullopt;
    return PaneFigures{*result, report.probe.reference, session.frame.kernel, {}};
  }
  if (!drawn || !drawn->frame || !report.inSight) return std::nullopt;
  const std::optional<FrameProbe> probe =
      probeFrame(*drawn->frame, report.pixel, session.receiver, report.plane);
  if (!probe || probe->probe.techniques.empty()) return std::nullopt;
  return PaneFigures{probe->probe.techniques.front(), probe->probe.reference,
                     drawn->subject.frame.kernel, probe->footprint};
}

}  // namespace umbra
