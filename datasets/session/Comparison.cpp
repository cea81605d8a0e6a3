#include "datasets/session/Comparison.h"

#include <array>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

constexpr std::array<std::string_view, 3> modeNames{"single", "wipe", "grid"};

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

}  // namespace umbra
