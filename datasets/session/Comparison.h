// Panes beside each other in the window: which techniques, with which settings, and how.
//
// Panes share the session's settings, unless one has some of its own. One pane is the active one:
// the session's technique and settings are its own, and whatever edits the session edits them.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/settings/Setting.h"
#include "filters/core/support/Parameters.h"

namespace umbra {

struct Session;

// One picture; one picture of two panes with a line between them; the panes beside each other.
enum class ComparisonMode { Single, Wipe, Grid };

// Values that differ from the defaults, by parameter.
using ParameterValues = std::map<std::string, ParameterValue>;

// Holds the settings that a pane has of its own. SettingInfo::pane says which ones it may have.
struct PaneSettings {
  std::optional<ParameterValues> parameters;   // of the pane's technique
  std::map<std::string, SettingValue> values;  // of the frame, by the setting's name

  bool operator==(const PaneSettings&) const = default;
};

struct Pane {
  std::string technique;
  // Of the active pane the same ones are set, but their values are what the others share, since
  // its own are the session's: activatePane() exchanges the two.
  PaneSettings own;

  bool linked() const { return own == PaneSettings{}; }  // shares every setting
  bool operator==(const Pane&) const = default;
};

struct Comparison {
  static constexpr std::size_t fewest = 2, most = 6;  // panes

  ComparisonMode mode = ComparisonMode::Single;
  std::vector<Pane> panes;  // `fewest` … `most`; none: a choice of the program's
  std::size_t active = 0;   // of `panes`
  double wipe = 0.5;  // where the line is: the part of the picture's width to its left, 0 … 1

  bool operator==(const Comparison&) const = default;
};

std::string_view nameOf(ComparisonMode mode);
// Throws BadCommandLine for an unknown name and lists the right ones. `where` is what the message
// begins with: a file and key.
ComparisonMode comparisonModeFrom(std::string_view name, std::string_view where);

// Panes that share every setting.
std::vector<Pane> linkedPanes(const std::vector<std::string>& techniques);

// The session's comparison with panes in any case, the active one of the session's technique. A
// wipe's sides are its first two panes, left and right, one of which is active.
Comparison comparisonOf(const Session& session);
// How many of its panes are to be seen.
std::size_t shownPanes(const Comparison& comparison);

// The session as it is while that pane of comparisonOf() is the active one. The others stay as they
// are.
void activatePane(Session& session, std::size_t pane);
Session activated(const Session& session, std::size_t pane);
// Exchanges the active pane's settings in the session with what the other panes share, which stand
// in the pane: done twice, all is as before.
void exchangeActive(Session& session);

// Makes `id` the session's technique. In a comparison a linked pane that shows it already becomes
// the active one; else the active pane shows it.
void chooseTechnique(Session& session, const std::string& id);
// Shows `id` in a pane; where that and another one are linked, and the other has it, the two change
// places.
void choosePane(Session& session, std::size_t pane, const std::string& id);

void setMode(Session& session, ComparisonMode mode);
// Shows that many panes, the active one among them. `known` are techniques to add from.
void setPaneCount(Session& session, std::size_t count, const std::vector<std::string>& known);

}  // namespace umbra
