// What tells panes apart, in words.
#pragma once

#include <string>
#include <vector>

#include "datasets/Session.h"

namespace umbra {

// For each pane of comparisonOf() that is shown: "radius 12 · half", the settings in which it
// differs from another one, parameters from another one of its technique; empty where there are
// none.
std::vector<std::string> paneLabels(const Session& session, const TechniqueCatalogue& catalogue);

}  // namespace umbra
