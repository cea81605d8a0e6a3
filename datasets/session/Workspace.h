// Everything that a person can set, and what the session file holds: the settings that panes share,
// and the panes with those of their own. What one pane shows is a Session, derived from both;
// nothing changes hands when another pane becomes the active one.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "datasets/session/Comparison.h"
#include "datasets/session/Session.h"

namespace umbra {

struct Workspace {
  Session shared;  // its technique is the active pane's
  Comparison comparison{};

  bool operator==(const Workspace&) const = default;
};

// What a comparison begins with: what the best known techniques make of the same picture.
inline constexpr std::array usualTechniques{"vsm", "lvsm", "evsm4", "msm"};

// The workspace's comparison with panes in any case, the active one of the shared technique. A
// wipe's sides are its first two panes, left and right, one of which is active.
Comparison comparisonOf(const Workspace& workspace);
// Returns the place of a linked pane of that technique, not `but`; the end where there is none.
std::size_t findLinked(const std::vector<Pane>& panes, std::string_view technique, std::size_t but);

// What that pane of comparisonOf() shows: the shared settings with the pane's own over them.
Session sessionOfPane(const Workspace& workspace, std::size_t pane);
// What the active pane shows, which is all there is where nothing is compared.
Session sessionOf(const Workspace& workspace);
// Makes `session` what the active pane shows: settings that are the pane's own change in the pane,
// all others in what the panes share.
void setSession(Workspace& workspace, const Session& session);
// Lets `change` edit what the active pane shows.
template <class Change>
void editSession(Workspace& workspace, Change change) {
  Session session = sessionOf(workspace);
  change(session);
  setSession(workspace, session);
}

}  // namespace umbra
