#include "datasets/session/PaneEditing.h"

#include <algorithm>
#include <utility>

#include "datasets/session/PaneChoice.h"
#include "datasets/session/SessionSettings.h"

namespace umbra {
namespace {

// Returns the settings of a frame that belong to one group of a pane's own.
std::vector<Setting> settingsOf(FrameSettings& frame, PaneSetting which) {
  std::vector<Setting> settings = settingsOf(frame);
  std::erase_if(settings, [&](const Setting& setting) { return setting.info.pane != which; });
  return settings;
}

// Makes one group of `values` the pane's own; `technique` is what the pane shows.
void takeOver(PaneSettings& own, PaneSetting which, const Session& values,
              const std::string& technique) {
  if (which == PaneSetting::Parameters)
    return void(own.parameters = parametersOf(values, technique));
  FrameSettings frame = values.frame;
  for (const Setting& setting : settingsOf(frame, which))
    own.values[std::string(setting.info.name)] = setting.get();
}

void giveUp(PaneSettings& own, PaneSetting which) {
  if (which == PaneSetting::Parameters) return own.parameters.reset();
  FrameSettings frame;
  for (const Setting& setting : settingsOf(frame, which))
    own.values.erase(std::string(setting.info.name));
}

Pane detached(const Session& shown) {
  Pane pane{shown.technique, {}};
  for (const PaneSetting which : paneSettings) takeOver(pane.own, which, shown, shown.technique);
  return pane;
}

// Takes away the panes with nothing of their own but for `pane`, which goes on meaning the same
// one.
void leaveSet(std::vector<Pane>& panes, std::size_t& pane) {
  for (std::size_t i = panes.size(); i-- > 0;) {
    if (i == pane || !panes[i].linked()) continue;
    panes.erase(panes.begin() + std::ptrdiff_t(i));
    pane -= pane > i;
  }
}

void insertBeside(Comparison& comparison, std::size_t pane, Pane copy) {
  std::vector<Pane>& panes = comparison.panes;
  if (comparison.mode == ComparisonMode::Single) {
    leaveSet(panes, pane);
    comparison.mode = ComparisonMode::Grid;
  }
  if (panes.size() == Comparison::most) {
    const std::size_t last = panes.size() - 1 - (pane == panes.size() - 1);
    panes.erase(panes.begin() + std::ptrdiff_t(last));
    pane -= pane > last;
  }
  if (comparison.mode == ComparisonMode::Wipe) std::swap(panes[0], panes[std::exchange(pane, 0)]);
  comparison.active = pane + 1;
  panes.insert(panes.begin() + std::ptrdiff_t(comparison.active), std::move(copy));
}

}  // namespace

bool hasOwn(const Pane& pane, PaneSetting which) {
  if (which == PaneSetting::Parameters) return pane.own.parameters.has_value();
  FrameSettings frame;
  const std::vector<Setting> settings = settingsOf(frame, which);
  return std::any_of(settings.begin(), settings.end(), [&](const Setting& setting) {
    return pane.own.values.contains(std::string(setting.info.name));
  });
}

void setOwn(Workspace& workspace, std::size_t pane, PaneSetting which, bool own) {
  workspace.comparison = comparisonOf(workspace);
  Pane& changed = workspace.comparison.panes[pane];
  if (own == hasOwn(changed, which)) return;
  if (own)
    takeOver(changed.own, which, workspace.shared, changed.technique);
  else
    giveUp(changed.own, which);
}

void setLinked(Workspace& workspace, std::size_t pane, bool linked) {
  for (const PaneSetting which : paneSettings) setOwn(workspace, pane, which, !linked);
}

void duplicatePane(Workspace& workspace, std::size_t pane) {
  Pane copy = detached(sessionOfPane(workspace, pane));
  workspace.comparison = comparisonOf(workspace);
  workspace.shared.technique = copy.technique;
  insertBeside(workspace.comparison, pane, std::move(copy));
}

void copyActiveSettings(Workspace& workspace, std::size_t pane) {
  const Session shown = sessionOf(workspace);
  workspace.comparison = comparisonOf(workspace);
  const Pane active = workspace.comparison.panes[workspace.comparison.active];
  Pane& changed = workspace.comparison.panes[pane];
  for (const PaneSetting which : paneSettings) {
    const bool parameters = which == PaneSetting::Parameters;
    if (parameters && changed.technique != active.technique) continue;
    if (hasOwn(changed, which) || hasOwn(active, which))
      takeOver(changed.own, which, shown, changed.technique);
  }
}

void closePane(Workspace& workspace, std::size_t pane) {
  workspace.comparison = comparisonOf(workspace);
  const std::size_t beside = pane == 0 ? 1 : pane - 1;
  if (workspace.comparison.active == pane) activatePane(workspace, beside);
  Comparison& comparison = workspace.comparison;
  if (comparison.mode == ComparisonMode::Wipe) setMode(workspace, ComparisonMode::Single);
  if (comparison.panes.size() <= Comparison::fewest) {
    // What the other one shows is all that is left to share.
    workspace = {sessionOf(workspace), {.wipe = comparison.wipe}};
    return;
  }
  comparison.panes.erase(comparison.panes.begin() + std::ptrdiff_t(pane));
  comparison.active -= comparison.active > pane;
}

}  // namespace umbra
