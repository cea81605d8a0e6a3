// Panes beside each other in the window: which techniques, with which settings of their own, and
// how they are laid out. What they share is in the workspace.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/session/Session.h"
#include "filters/core/settings/Setting.h"

namespace umbra {

// One picture; one picture of two panes with a line between them; the panes beside each other.
enum class ComparisonMode { Single, Wipe, Grid };

// Holds the settings that a pane has of its own, over those that panes share. SettingInfo::pane
// says which ones it may have.
struct PaneSettings {
  std::optional<ParameterValues> parameters;   // of the pane's technique
  std::map<std::string, SettingValue> values;  // of the frame, by the setting's name

  bool operator==(const PaneSettings&) const = default;
};

struct Pane {
  std::string technique;
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

// How many of its panes are to be seen.
std::size_t shownPanes(const Comparison& comparison);

}  // namespace umbra
