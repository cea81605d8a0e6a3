// Which panes a comparison has, what they show, and which one is active. Panes are numbered as in
// comparisonOf().
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "datasets/session/Workspace.h"

namespace umbra {

// Makes the pane the active one; every pane stays as it is.
void activatePane(Workspace& workspace, std::size_t pane);

// Makes `id` the technique that is looked at. In a comparison a linked pane that shows it already
// becomes the active one; else the active pane shows it.
void chooseTechnique(Workspace& workspace, const std::string& id);
// Shows `id` in a pane; where that and another one are linked, and the other has it, the two change
// places.
void choosePane(Workspace& workspace, std::size_t pane, const std::string& id);

void setMode(Workspace& workspace, ComparisonMode mode);
// Shows that many panes, the active one among them. `known` are techniques to add from.
void setPaneCount(Workspace& workspace, std::size_t count, const std::vector<std::string>& known);

}  // namespace umbra
