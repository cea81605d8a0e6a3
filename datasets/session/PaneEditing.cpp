#include "datasets/session/PaneEditing.h"

#include <algorithm>
#include <utility>

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

// While `change` is at work, the session is what the panes share and own settings are in every
// pane.
template <class Change>
void whileShared(Session& session, Change change) {
  session.comparison = comparisonOf(session);
  exchangeActive(session);
  change(session.comparison.panes);
  session.technique = session.comparison.panes[session.comparison.active].technique;
  exchangeActive(session);
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

// To be done while the settings are shared.
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

void setOwn(Session& session, std::size_t pane, PaneSetting which, bool own) {
  whileShared(session, [&](std::vector<Pane>& panes) {
    Pane& changed = panes[pane];
    if (own == hasOwn(changed, which)) return;
    if (own)
      takeOver(changed.own, which, session, changed.technique);
    else
      giveUp(changed.own, which);
  });
}

void setLinked(Session& session, std::size_t pane, bool linked) {
  for (const PaneSetting which : paneSettings) setOwn(session, pane, which, !linked);
}

void duplicatePane(Session& session, std::size_t pane) {
  Pane copy = detached(activated(session, pane));
  whileShared(session,
              [&](std::vector<Pane>&) { insertBeside(session.comparison, pane, std::move(copy)); });
}

void copyActiveSettings(Session& session, std::size_t pane) {
  const Session shown = session;
  whileShared(session, [&](std::vector<Pane>& panes) {
    const Pane& active = panes[session.comparison.active];
    Pane& changed = panes[pane];
    for (const PaneSetting which : paneSettings) {
      const bool parameters = which == PaneSetting::Parameters;
      if (parameters && changed.technique != active.technique) continue;
      if (hasOwn(changed, which) || hasOwn(active, which))
        takeOver(changed.own, which, shown, changed.technique);
    }
  });
}

void closePane(Session& session, std::size_t pane) {
  session.comparison = comparisonOf(session);
  const std::size_t beside = pane == 0 ? 1 : pane - 1;
  if (session.comparison.active == pane) activatePane(session, beside);
  Comparison& comparison = session.comparison;
  if (comparison.mode == ComparisonMode::Wipe) setMode(session, ComparisonMode::Single);
  if (comparison.panes.size() <= Comparison::fewest) {
    // What the other one is drawn with, is the session's.
    const double wipe = comparison.wipe;
    comparison = Comparison{};
    comparison.wipe = wipe;
    return;
  }
  comparison.panes.erase(comparison.panes.begin() + std::ptrdiff_t(pane));
  comparison.active -= comparison.active > pane;
}

}  // namespace umbra
