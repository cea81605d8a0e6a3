// Techniques beside each other in the window: which, and how.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace umbra {

struct Session;

// One picture; one picture of two techniques with a line between them; a pane for each technique.
enum class ComparisonMode { Single, Wipe, Grid };

struct Comparison {
  static constexpr std::size_t fewest = 2, most = 6;  // techniques

  ComparisonMode mode = ComparisonMode::Single;
  // In the order of the panes, none twice, `fewest` … `most`; none: a choice of the program's.
  std::vector<std::string> techniques;
  double wipe = 0.5;  // where the line is: the part of the picture's width to its left, 0 … 1

  bool operator==(const Comparison&) const = default;
};

std::string_view nameOf(ComparisonMode mode);
// Throws BadCommandLine for an unknown name and lists the right ones. `where` is what the message
// begins with: a file and key.
ComparisonMode comparisonModeFrom(std::string_view name, std::string_view where);

// The techniques of the panes; the session's is one of them.
std::vector<std::string> panesOf(const Session& session);
// What a wipe shows to the right of its line; the session's technique is on the left.
std::string wipeTechniqueOf(const Session& session);

// Makes `id` the session's technique: in a comparison it takes the place of the one that was,
// unless a pane has it already.
void chooseTechnique(Session& session, const std::string& id);
// Shows `id` in the pane of `current`; where another pane has it, the two change places.
void choosePane(Session& session, const std::string& current, const std::string& id);
// Shows that many panes, the session's technique among them. `known` are techniques to add from.
void setPaneCount(Session& session, std::size_t count, const std::vector<std::string>& known);

}  // namespace umbra
