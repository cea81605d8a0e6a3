#include "datasets/session/Comparison.h"

#include <algorithm>
#include <array>
#include <utility>

#include "datasets/session/SessionSettings.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

constexpr std::array<std::string_view, 3> modeNames{"single", "wipe", "grid"};
// What the best known techniques make of the same picture.
constexpr std::array usualTechniques{"vsm", "lvsm", "evsm4", "msm"};

// The place of a linked pane of that technique, not `but`; the end where there is none.
std::size_t findLinked(const std::vector<Pane>& panes, std::string_view id, std::size_t but) {
  std::size_t i = 0;
  while (i < panes.size() && (i == but || panes[i].technique != id || !panes[i].linked())) ++i;
  return i;
}

// Another technique in the active pane or in one beside it, with parameters of its own where the
// one that was had them.
void exchangeTechnique(Session& session, std::size_t pane, const std::string& id) {
  Pane& changed = session.comparison.panes[pane];
  const bool active = pane == session.comparison.active;
  Session shared = session;
  exchangeActive(shared);
  if (changed.own.parameters) {
    if (active) setParameters(session, changed.technique, *changed.own.parameters);
    changed.own.parameters = parametersOf(shared, id);
  }
  changed.technique = id;
  if (active) session.technique = id;
}

}  // namespace

std::string_view nameOf(ComparisonMode mode) {
  return modeNames[std::size_t(mode)];
}

ComparisonMode comparisonModeFrom(std::string_view name, std::string_view where) {
  for (std::size_t i = 0; i < modeNames.size(); ++i)
    if (modeNames[i] == name) return ComparisonMode(i);
  throw Error(ErrorKind::BadCommandLine, std::string(where) + ": '" + std::string(name) +
                                             "' is not right, it takes single, wipe or grid");
}

std::vector<Pane> linkedPanes(const std::vector<std::string>& techniques) {
  std::vector<Pane> panes;
  for (const std::string& id : techniques) panes.push_back({id, {}});
  return panes;
}

Comparison comparisonOf(const Session& session) {
  Comparison comparison = session.comparison;
  std::vector<Pane>& panes = comparison.panes;
  std::size_t& active = comparison.active;
  if (panes.empty()) panes = linkedPanes({usualTechniques.begin(), usualTechniques.end()});
  if (active >= panes.size()) active = 0;
  if (panes[active].technique != session.technique) {  // chosen while nothing was compared
    const std::size_t place = findLinked(panes, session.technique, active);
    if (place < panes.size() && panes[active].linked())
      active = place;
    else
      panes[active].technique = session.technique;
    if (panes[active].own.parameters)
      panes[active].own.parameters = parametersOf(session, session.technique);
  }
  if (comparison.mode == ComparisonMode::Wipe && active > 1)
    std::swap(panes[1], panes[std::exchange(active, 1)]);
  return comparison;
}

std::size_t shownPanes(const Comparison& comparison) {
  switch (comparison.mode) {
    case ComparisonMode::Wipe:
      return 2;
    case ComparisonMode::Grid:
      return comparison.panes.size();
    case ComparisonMode::Single:
      break;
  }
  return 1;
}

void exchangeActive(Session& session) {
  if (session.comparison.panes.empty()) return;
  Pane& pane = session.comparison.panes[session.comparison.active];
  for (const Setting& setting : settingsOf(session.frame)) {
    const auto own = pane.own.values.find(std::string(setting.info.name));
    if (own != pane.own.values.end()) setting.put(std::exchange(own->second, setting.get()));
  }
  if (!pane.own.parameters) return;
  ParameterValues values = parametersOf(session, pane.technique);
  std::swap(values, *pane.own.parameters);
  setParameters(session, pane.technique, std::move(values));
}

void activatePane(Session& session, std::size_t pane) {
  session.comparison = comparisonOf(session);
  exchangeActive(session);
  session.comparison.active = pane;
  session.technique = session.comparison.panes[pane].technique;
  exchangeActive(session);
}

Session activated(const Session& session, std::size_t pane) {
  Session other = session;
  activatePane(other, pane);
  return other;
}

void chooseTechnique(Session& session, const std::string& id) {
  if (id == session.technique) return;
  const ComparisonMode mode = session.comparison.mode;
  const Comparison comparison = comparisonOf(session);
  const Pane& active = comparison.panes[comparison.active];
  if (mode == ComparisonMode::Single && active.linked()) return void(session.technique = id);
  const std::size_t place = findLinked(comparison.panes, id, comparison.active);
  if (active.linked() && place < shownPanes(comparison)) return activatePane(session, place);
  choosePane(session, comparison.active, id);
}

void choosePane(Session& session, std::size_t pane, const std::string& id) {
  session.comparison = comparisonOf(session);
  std::vector<Pane>& panes = session.comparison.panes;
  std::size_t& active = session.comparison.active;
  if (panes[pane].technique == id) return;
  const std::size_t other = findLinked(panes, id, pane);
  if (other == panes.size() || !panes[pane].linked()) return exchangeTechnique(session, pane, id);
  std::swap(panes[pane], panes[other]);
  // Whoever changes the active pane means to look at another technique there; elsewhere the active
  // one goes where it was sent.
  if (active == other) active = pane;
  session.technique = panes[active].technique;
}

void setMode(Session& session, ComparisonMode mode) {
  session.comparison.mode = mode;
  if (mode != ComparisonMode::Single) session.comparison = comparisonOf(session);
}

void setPaneCount(Session& session, std::size_t count, const std::vector<std::string>& known) {
  setMode(session, ComparisonMode::Grid);
  std::vector<Pane>& panes = session.comparison.panes;
  std::size_t& active = session.comparison.active;
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
