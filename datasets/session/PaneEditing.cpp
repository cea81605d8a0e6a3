#include "datasets/session/PaneEditing.h"

#include <algorithm>
#include <utility>

namespace umbra {
namespace {

// Calls `visit(own, value, setting)` for every setting; `values` are the session's for the pane.
template <class Visit>
void visitAll(PaneSettings& own, const Session& values, const std::string& technique, Visit visit) {
  visit(own.parameters, parametersOf(values, technique), PaneSetting::Parameters);
  visitFrame(own, values.frame, visit);
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
  visitAll(pane.own, shown, shown.technique,
           [](auto& own, const auto& value, PaneSetting) { own = value; });
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

bool hasOwn(const Pane& pane, PaneSetting setting) {
  if (setting == PaneSetting::Parameters) return pane.own.parameters.has_value();
  bool found = false;
  const FrameSettings none;
  visitFrame(pane.own, none, [&](const auto& own, const auto&, PaneSetting which) {
    found = found || (which == setting && own.has_value());
  });
  return found;
}

void setOwn(Session& session, std::size_t pane, PaneSetting setting, bool own) {
  whileShared(session, [&](std::vector<Pane>& panes) {
    visitAll(panes[pane].own, session, panes[pane].technique,
             [&](auto& held, const auto& shared, PaneSetting which) {
               if (which != setting || own == held.has_value()) return;
               if (own)
                 held = shared;
               else
                 held.reset();
             });
  });
}

void setLinked(Session& session, std::size_t pane, bool linked) {
  for (int i = 0; i <= int(PaneSetting::Bias); ++i) setOwn(session, pane, PaneSetting(i), !linked);
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
    visitAll(changed.own, shown, changed.technique,
             [&](auto& own, const auto& value, PaneSetting which) {
               const bool parameters = which == PaneSetting::Parameters;
               if (parameters && changed.technique != active.technique) return;
               if (own || hasOwn(active, which)) own = value;
             });
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
