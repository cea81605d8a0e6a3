// Saved probes on the command line: they are chosen by name and written as one table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/probe/ProbeSheet.h"
#include "app/frames/PaneProbes.h"
#include "app/frames/SceneProbe.h"
#include "app/output/Output.h"
#include "datasets/session/Session.h"

namespace umbra {

struct NamedResult {
  NamedProbe saved;
  std::optional<Probe> probe;
  Json json;           // the JSON of a single probe; null without one
  std::string reason;  // why there is no probe
  std::optional<double>
      truth;  // the reference that errors are against, where it is not the probe's own
  std::vector<PaneProbe> panes{};  // of a session that compares
};

// The saved probe of that name, or every one for "all". Throws BadCommandLine that names the probes
// that there are.
std::vector<NamedProbe> chosenProbes(const Session& session, const std::string& name);

// "umbrascope-probes/1": {"format", "source", "probes": [{"name", … a probe's fields}]}, with
// "reason" in place of the fields where a probe cannot be read.
Json namedToJson(const Json& source, const std::vector<NamedResult>& results);

// A line for each probe: its reference, and each technique's visibility.
std::string namedText(const std::vector<NamedResult>& results);

// Writes probes.json and probes.csv.
void writeNamed(OutputFolder& folder, const Json& object, const std::vector<NamedResult>& results);

}  // namespace umbra
