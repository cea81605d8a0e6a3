#include "ui/panes/ShownPanes.h"

#include <algorithm>

#include "filters/core/technique/Composition.h"
#include "filters/core/technique/TechniqueEquality.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

ShownPane paneOf(Session session, const TechniqueCatalogue& catalogue) {
  std::shared_ptr<const Technique> technique = techniqueOf(session, catalogue, session.technique);
  const std::string refusal = whyImpossible(session.frame, *technique);
  return {std::move(session), std::move(technique), style::text(refusal)};
}

}  // namespace

ComparisonMode shownMode(const SessionController& controller) {
  return controller.document().content.scene ? controller.workspace().comparison.mode
                                             : ComparisonMode::Single;
}

ShownPanes panesToShow(const SessionController& controller) {
  ShownPanes shown{shownMode(controller), {}, 0};
  if (shown.mode == ComparisonMode::Single) {
    shown.panes.push_back(paneOf(controller.session(), controller.catalogue()));
    return shown;
  }
  const Workspace& workspace = controller.workspace();
  const Comparison comparison = comparisonOf(workspace);
  const std::size_t count = shownPanes(comparison);
  for (std::size_t i = 0; i < count; ++i)
    shown.panes.push_back(paneOf(sessionOfPane(workspace, i), controller.catalogue()));
  if (count > 1) shown.active = comparison.active;
  return shown;
}

bool isSetAsActive(const ShownPane& pane, const SessionController& controller) {
  const auto& techniques = controller.techniques();
  return pane.session.frame == controller.session().frame &&
         std::any_of(techniques.begin(), techniques.end(), [&](const auto& technique) {
           return sameSettings(*technique, *pane.technique);
         });
}

}  // namespace umbra
