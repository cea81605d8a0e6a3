// A probe as files and as text.
#pragma once

#include <string>
#include <vector>

#include "analysis/probe/Probe.h"
#include "app/display/Display.h"
#include "app/output/Output.h"
#include "datasets/maps/DepthFile.h"

namespace umbra {

// probe.json, and the plots curves, histogram and cdf, and those of `more`, each as .png, .svg,
// .pdf and .csv. The curve of technique `selected` is emphasised.
void writeProbe(OutputFolder& folder, Display& display, const Probe& probe, const Json& json,
                std::string_view selected, int bins, std::vector<Plot> more = {});

// Every explaining plot that has something to show of the probe that was taken of `request`. Can be
// interrupted.
std::vector<Plot> explainingPlotsOf(const ProbeRequest& request, const Probe& probe,
                                    const Session& session);

// For people: the region, its statistics and a row for every technique. Texels are counted as
// `file` does, and the receiver is also told in its measures, where there is one.
std::string probeText(const Probe& probe, const DepthFile* file = nullptr);
// Every technique's steps, and what goes wrong.
std::string tracesText(const Probe& probe);

}  // namespace umbra
