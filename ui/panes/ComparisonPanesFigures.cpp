// What the panes make of the probed point.
#include <algorithm>

#include "filters/core/technique/TechniqueEquality.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/panes/PaneHeader.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"

namespace umbra {
void ComparisonPanes::refreshFigures() {
  for (std::size_t i = 0; i < figures_.size(); ++i)
    figures_[i] = i < shown_.size() ? figuresOf(i) : std::nullopt;
  showErrors();
  emit figuresChanged();
}

// Beside the technique, of which the report has all.
bool ComparisonPanes::isSetAsActive(std::size_t pane) const {
  const auto& techniques = controller_.techniques();
  return shown_[pane].session.frame == controller_.session().frame &&
         std::any_of(techniques.begin(), techniques.end(), [&](const auto& technique) {
           return sameSettings(*technique, *shown_[pane].technique);
         });
}

// Where the active pane has the same settings, the report has them too; else the pane's picture
// kept what it was drawn of.
std::optional<PaneFigures> ComparisonPanes::figuresOf(std::size_t pane) {
  const auto& report = prober_.report();
  // A depth file may have been opened that refresh() has yet to come to.
  if (!report || !controller_.document().content.scene) return std::nullopt;
  const Session& session = controller_.session();
  if (isSetAsActive(pane)) {
    const TechniqueResult* result = resultOf(report->probe, shown_[pane].session.technique);
    if (!result) return std::nullopt;
    return PaneFigures{*result, report->probe.reference, session.frame.kernel, {}};
  }
  const DrawnPicture drawn = drawnAsIs(pane);
  if (!drawn || drawn->picture.isNull()) return std::nullopt;
  if (!report->inSight) return std::nullopt;
  const FrameEvidence& evidence = drawn->evidence;
  const auto mapOf = [&](int cascade) -> const DepthMap& {
    return evidence.maps.empty() ? view_.lastFrame()->depthMap(cascade)
                                 : evidence.maps[std::size_t(cascade)];
  };
  const std::optional<FrameProbe> probe = probeFrame(
      evidence, drawn->subject.frame, mapOf, report->pixel, session.receiver, report->plane);
  if (!probe || probe->probe.techniques.empty()) return std::nullopt;
  return PaneFigures{probe->probe.techniques.front(), probe->probe.reference,
                     drawn->subject.frame.kernel, probe->footprint};
}

void ComparisonPanes::showErrors() {
  for (std::size_t i = 0; i < shown_.size(); ++i)
    headers_[i]->setError(figures_[i] ? std::optional(figures_[i]->result.error) : std::nullopt);
}

}  // namespace umbra
