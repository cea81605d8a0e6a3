// What tells panes apart, in words.
#pragma once

#include <string>
#include <vector>

#include "datasets/session/Workspace.h"

namespace umbra {

// For each pane of comparisonOf() that is shown: "radius 12 · half", the settings in which it is
// not as most of them are, parameters as most of its technique; empty where there are none.
std::vector<std::string> paneLabels(const Workspace& workspace,
                                    const TechniqueCatalogue& catalogue);

}  // namespace umbra
