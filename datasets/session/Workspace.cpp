#include "datasets/session/Workspace.h"

#include <string>
#include <utility>
#include <vector>

#include "datasets/session/SessionSettings.h"

namespace umbra {

std::size_t findLinked(const std::vector<Pane>& panes, std::string_view technique,
                       std::size_t but) {
  std::size_t i = 0;
  while (i < panes.size() && (i == but || panes[i].technique != technique || !panes[i].linked()))
    ++i;
  return i;
}

Comparison comparisonOf(const Workspace& workspace) {
  const Session& shared = workspace.shared;
  Comparison comparison = workspace.comparison;
  std::vector<Pane>& panes = comparison.panes;
  std::size_t& active = comparison.active;
  if (panes.empty()) panes = linkedPanes({usualTechniques.begin(), usualTechniques.end()});
  if (active >= panes.size()) active = 0;
  if (panes[active].technique != shared.technique) {  // chosen while nothing was compared
    const std::size_t place = findLinked(panes, shared.technique, active);
    if (place < panes.size() && panes[active].linked())
      active = place;
    else
      panes[active].technique = shared.technique;
    if (panes[active].own.parameters)
      panes[active].own.parameters = parametersOf(shared, shared.technique);
  }
  if (comparison.mode == ComparisonMode::Wipe && active > 1)
    std::swap(panes[1], panes[std::exchange(active, 1)]);
  return comparison;
}

Session sessionOfPane(const Workspace& workspace, std::size_t pane) {
  const Pane shown = comparisonOf(workspace).panes[pane];
  Session session = workspace.shared;
  session.technique = shown.technique;
  for (const Setting& setting : settingsOf(session.frame)) {
    const auto own = shown.own.values.find(std::string(setting.info.name));
    if (own != shown.own.values.end()) setting.put(own->second);
  }
  if (shown.own.parameters) setParameters(session, shown.technique, *shown.own.parameters);
  return session;
}

Session sessionOf(const Workspace& workspace) {
  if (workspace.comparison.panes.empty()) return workspace.shared;
  return sessionOfPane(workspace, comparisonOf(workspace).active);
}

void setSession(Workspace& workspace, const Session& session) {
  Comparison comparison = comparisonOf(workspace);
  const Session shared = std::exchange(workspace.shared, session);
  Pane& active = comparison.panes[comparison.active];
  if (workspace.comparison.panes.empty() || active.linked()) return;
  FrameSettings former = shared.frame;
  const std::vector<Setting> formerSettings = settingsOf(former);
  for (const Setting& setting : settingsOf(workspace.shared.frame)) {
    const auto own = active.own.values.find(std::string(setting.info.name));
    if (own == active.own.values.end()) continue;
    own->second = setting.get();
    setting.put(settingNamed(formerSettings, setting.info.name, setting.info.name).get());
  }
  if (active.own.parameters) {
    const std::string technique = std::exchange(active.technique, session.technique);
    active.own.parameters = parametersOf(session, session.technique);
    setParameters(workspace.shared, technique, parametersOf(shared, technique));
  }
  workspace.comparison = std::move(comparison);
}

}  // namespace umbra
