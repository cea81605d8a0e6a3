#include "datasets/Comparison.h"

#include <algorithm>
#include <array>

#include "datasets/Session.h"
#include "filters/core/Error.h"

namespace umbra {
namespace {

constexpr std::array<std::string_view, 3> names{"single", "wipe", "grid"};
// What the best known techniques make of the same picture.
constexpr std::array usual{"vsm", "lvsm", "evsm4", "msm"};

bool has(const std::vector<std::string>& ids, std::string_view id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

void replace(std::vector<std::string>& ids, const std::string& before, const std::string& after) {
  if (has(ids, after)) return;
  std::replace(ids.begin(), ids.end(), before, after);
}

}  // namespace

std::string_view nameOf(ComparisonMode mode) {
  return names[std::size_t(mode)];
}

ComparisonMode comparisonModeFrom(std::string_view name, std::string_view where) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return ComparisonMode(i);
  throw Error(ErrorKind::BadCommandLine, std::string(where) + ": '" + std::string(name) +
                                             "' is not right, it takes single, wipe or grid");
}

std::vector<std::string> panesOf(const Session& session) {
  std::vector<std::string> panes = session.comparison.techniques;
  if (panes.empty()) panes.assign(usual.begin(), usual.end());
  if (!has(panes, session.technique)) panes.front() = session.technique;
  return panes;
}

std::string wipeTechniqueOf(const Session& session) {
  const std::vector<std::string> panes = panesOf(session);
  return panes[panes.front() == session.technique ? 1 : 0];
}

void chooseTechnique(Session& session, const std::string& id) {
  const std::string before = session.technique;
  if (id == before) return;
  if (session.comparison.mode == ComparisonMode::Wipe) {
    // The right side stays, or takes what the left one had.
    const std::string right = wipeTechniqueOf(session);
    std::vector<std::string> panes = panesOf(session);
    replace(panes, before, id);
    session.technique = id;
    session.comparison.techniques = panes;
    return choosePane(session, wipeTechniqueOf(session), id == right ? before : right);
  }
  if (session.comparison.mode == ComparisonMode::Grid) {
    std::vector<std::string> panes = panesOf(session);
    replace(panes, before, id);
    session.comparison.techniques = panes;
  }
  session.technique = id;
}

void choosePane(Session& session, const std::string& current, const std::string& id) {
  if (current == id) return;
  std::vector<std::string> panes = panesOf(session);
  const bool active = current == session.technique;
  const auto place = std::find(panes.begin(), panes.end(), current);
  const auto other = std::find(panes.begin(), panes.end(), id);
  if (place == panes.end()) return;
  if (other != panes.end())
    std::iter_swap(place, other);
  else
    *place = id;
  session.comparison.techniques = panes;
  // Whoever changes the active pane means to look at another technique there; a wipe's sides
  // change places when the right one becomes the left one.
  if (active)
    session.technique = id;
  else if (session.comparison.mode == ComparisonMode::Wipe && id == session.technique)
    session.technique = current;
}

void setPaneCount(Session& session, std::size_t count, const std::vector<std::string>& known) {
  std::vector<std::string> panes = panesOf(session);
  while (panes.size() > count) {
    const auto last = std::find_if(panes.rbegin(), panes.rend(),
                                   [&](const std::string& id) { return id != session.technique; });
    panes.erase(std::next(last).base());
  }
  const auto addFrom = [&](const auto& ids) {
    for (const auto& id : ids)
      if (panes.size() < count && !has(panes, id)) panes.emplace_back(id);
  };
  addFrom(usual);
  addFrom(known);
  session.comparison.techniques = panes;
}

}  // namespace umbra
