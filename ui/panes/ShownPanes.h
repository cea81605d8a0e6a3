// The panes that the session puts beside each other, as they are to be shown.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "datasets/session/Workspace.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

class SessionController;

struct ShownPane {
  Session session;  // what the pane shows
  std::shared_ptr<const Technique> technique;
  QString refusal;  // why it cannot be drawn; empty where it can
};

struct ShownPanes {
  ComparisonMode mode = ComparisonMode::Single;
  std::vector<ShownPane> panes;  // the session's alone where none is compared
  std::size_t active = 0;

  std::size_t size() const { return panes.size(); }
  const ShownPane& operator[](std::size_t pane) const { return panes[pane]; }
};

// The session's mode; Single while a depth file is open, which has no picture to compare.
ComparisonMode shownMode(const SessionController& controller);
ShownPanes panesToShow(const SessionController& controller);
// Whether the pane has the active pane's settings, its technique aside: a probe of the active pane
// then tells what this one shows.
bool isSetAsActive(const ShownPane& pane, const SessionController& controller);

}  // namespace umbra
