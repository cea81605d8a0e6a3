#include "datasets/session/PaneChoice.h"

#include <utility>

namespace umbra {
namespace {

// Shows another technique in a pane. Parameters of its own, if it has some, become those that panes
// share of that technique.
void exchangeTechnique(Workspace& workspace, std::size_t pane, const std::string& id) {
  Pane& changed = workspace.comparison.panes[pane];
  if (changed.own.parameters) changed.own.parameters = parametersOf(workspace.shared, id);
  changed.technique = id;
}

}  // namespace

void activatePane(Workspace& workspace, std::size_t pane) {
  workspace.comparison = comparisonOf(workspace);
  workspace.comparison.active = pane;
  workspace.shared.technique = workspace.comparison.panes[pane].technique;
}

void chooseTechnique(Workspace& workspace, const std::string& id) {
  if (id == workspace.shared.technique) return;
  const ComparisonMode mode = workspace.comparison.mode;
  const Comparison comparison = comparisonOf(workspace);
  const Pane& active = comparison.panes[comparison.active];
  if (mode == ComparisonMode::Single && active.linked())
    return void(workspace.shared.technique = id);
  const std::size_t place = findLinked(comparison.panes, id, comparison.active);
  if (active.linked() && place < shownPanes(comparison)) return activatePane(workspace, place);
  choosePane(workspace, comparison.active, id);
}

void choosePane(Workspace& workspace, std::size_t pane, const std::string& id) {
  workspace.comparison = comparisonOf(workspace);
  std::vector<Pane>& panes = workspace.comparison.panes;
  std::size_t& active = workspace.comparison.active;
  if (panes[pane].technique == id) return;
  const std::size_t other = findLinked(panes, id, pane);
  if (other == panes.size() || !panes[pane].linked()) {
    exchangeTechnique(workspace, pane, id);
  } else {
    std::swap(panes[pane], panes[other]);
    // Whoever changes the active pane means to look at another technique there; elsewhere the
    // active one goes where it was sent.
    if (active == other) active = pane;
  }
  workspace.shared.technique = panes[active].technique;
}

void setMode(Workspace& workspace, ComparisonMode mode) {
  workspace.comparison.mode = mode;
  if (mode != ComparisonMode::Single) workspace.comparison = comparisonOf(workspace);
}

void setPaneCount(Workspace& workspace, std::size_t count, const std::vector<std::string>& known) {
  setMode(workspace, ComparisonMode::Grid);
  std::vector<Pane>& panes = workspace.comparison.panes;
  std::size_t& active = workspace.comparison.active;
  while (panes.size() > count) {
    const std::size_t last = panes.size() - 1;
    if (active == last) std::swap(panes[last], panes[--active]);
    panes.pop_back();
  }
  const auto addFrom = [&](const auto& ids) {
    for (const auto& id : ids)
      if (panes.size() < count && findLinked(panes, id, panes.size()) == panes.size())
        panes.push_back({std::string(id), {}});
  };
  addFrom(usualTechniques);
  addFrom(known);
}

}  // namespace umbra
