// What the panes make of the probed point.
#include <algorithm>

#include "filters/core/TechniqueEquality.h"
#include "ui/ComparisonPanes.h"
#include "ui/PaneHeader.h"
#include "ui/Prober.h"
#include "ui/SceneView.h"
#include "ui/SessionController.h"

namespace umbra {
namespace {

// Of surfaces in sight of one pixel, relative to the distance from the origin.
constexpr double samePlace = 0.05;

}  // namespace

void ComparisonPanes::refreshFigures() {
  for (std::size_t i = 0; i < figures_.size(); ++i)
    figures_[i] = i < shown_.size() ? figuresOf(i) : std::nullopt;
  showErrors();
  emit figuresChanged();
}

// Where the active pane has the same settings, the report has them too; else the pane's picture
// kept what it was drawn of.
std::optional<PaneFigures> ComparisonPanes::figuresOf(std::size_t pane) {
  const auto& report = prober_.report();
  if (!report) return std::nullopt;
  const Shown& shown = shown_[pane];
  const Session& session = controller_.session();
  const auto& techniques = controller_.techniques();
  const bool asActive = shown.session.frame == session.frame &&
                        std::any_of(techniques.begin(), techniques.end(), [&](const auto& t) {
                          return sameSettings(*t, *shown.technique);
                        });
  if (asActive) {
    const TechniqueResult* result = resultOf(report->probe, shown.session.technique);
    if (!result) return std::nullopt;
    return PaneFigures{*result, report->probe.reference, session.frame.kernel, {}};
  }
  const DrawnPicture drawn = drawnAsIs(pane);
  if (!drawn || drawn->picture.isNull() || !report->point) return std::nullopt;
  const auto surface = view_.surfaceAt(report->pixel);
  if (!surface ||
      (surface->world - *report->point).norm() > samePlace * (1.0 + report->point->norm()))
    return std::nullopt;  // something stands in front of the point
  std::optional<FrameProbe> probe =
      probeFrame(drawn->evidence, drawn->subject.frame, report->pixel, session.receiver,
                 view_.surfacePlane(report->pixel, *surface));
  if (!probe || probe->probe.techniques.empty()) return std::nullopt;
  return PaneFigures{probe->probe.techniques.front(), probe->probe.reference,
                     drawn->subject.frame.kernel, std::move(probe->footprint)};
}

void ComparisonPanes::showErrors() {
  for (std::size_t i = 0; i < shown_.size(); ++i)
    headers_[i]->setError(figures_[i] ? std::optional(figures_[i]->result.error) : std::nullopt);
}

}  // namespace umbra
