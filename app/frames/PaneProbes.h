// Probes of a session that compares: every pane's technique with the pane's own settings, at the
// place of one probe.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/probe/Probe.h"
#include "app/frames/Drawings.h"
#include "app/output/Output.h"

namespace umbra {

struct PaneProbe {
  Drawing drawing;
  std::optional<Probe> probe;  // of the pane's technique alone
  Json json;                   // the fields of probeToJson
  std::string reason;          // why the pane has no probe there
};

// A probe, and what a report says of it.
struct TakenProbe {
  Probe probe;
  Json json;
};

// Takes the pane's probe. A pane that cannot be drawn says why it has none, as one does for which
// `take` throws.
PaneProbe probePane(const Drawing& pane, const std::function<TakenProbe()>& take);

// [{"pane", "settings", … a probe's fields}], with "reason" in place of the fields where a pane has
// no probe. "settings" are those that differ from another pane's.
Json panesToJson(const std::vector<PaneProbe>& panes);
// A line for each pane: its settings, reference, visibility and error.
std::string panesText(const std::vector<PaneProbe>& panes);

}  // namespace umbra
