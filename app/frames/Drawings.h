// Lists what a command draws or measures: techniques with the settings of one session, or the panes
// of a session that compares, each with its own.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/output/Output.h"
#include "datasets/session/Workspace.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

struct Drawing {
  Session session;  // what the pane shows
  std::shared_ptr<Technique> technique;
  std::string label;  // for people: "Variance (VSM) · radius 12"
  // For files and parts: the technique's id, and the pane's number where another pane has the same
  // technique: "vsm-3".
  std::string name;
  std::size_t pane = 0;  // counts from 1; 0 is no pane
  std::string refusal;   // why the pane cannot be drawn; empty where it can
  // The pane's settings and parameters that differ from another pane's, by their names in
  // `umbrascope settings` and as TECHNIQUE.PARAMETER.
  Json differences = Json::object();
};

// Every setting and parameter that a pane may have of its own, by name.
std::map<std::string, Json> valuesOf(const Drawing& drawing);

// One for each technique.
std::vector<Drawing> drawingsOf(const Session& session,
                                const std::vector<std::shared_ptr<Technique>>& techniques);
// One for each pane that the workspace shows, also for those that cannot be drawn.
std::vector<Drawing> panesOf(const Workspace& workspace, const TechniqueCatalogue& catalogue);
// One for each pane that the workspace shows. Of panes beside each other, one with impossible
// settings is left out, with a warning that says why. Throws BadCommandLine where no pane is left.
std::vector<Drawing> drawingsOfPanes(const Workspace& workspace,
                                     const TechniqueCatalogue& catalogue);

}  // namespace umbra
