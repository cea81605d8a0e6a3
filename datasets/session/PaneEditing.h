// What one does to a single pane of a comparison, numbered as in comparisonOf().
#pragma once

#include "datasets/session/Workspace.h"

namespace umbra {

bool hasOwn(const Pane& pane, PaneSetting setting);
// A setting becomes the pane's own as it is; one that is its own no longer becomes what the other
// panes share.
void setOwn(Workspace& workspace, std::size_t pane, PaneSetting setting, bool own);
void setLinked(Workspace& workspace, std::size_t pane, bool linked);  // every setting

// A pane beside it with the same technique and settings, all of them its own; it becomes the active
// one. Of one picture, two panes, beside those with settings of their own that were there when it
// was the only one; in a wipe, the other side. Where there are `most` panes already,
// the last of the others makes room.
void duplicatePane(Workspace& workspace, std::size_t pane);
// Gives the pane the active pane's settings, and its parameters if both have the same technique.
// The pane goes on sharing what it shared and can still share.
void copyActiveSettings(Workspace& workspace, std::size_t pane);
// Takes the pane away. If two panes are to be seen, the other one is left as a single picture;
// panes behind a wipe stay for the next comparison.
void closePane(Workspace& workspace, std::size_t pane);

}  // namespace umbra
