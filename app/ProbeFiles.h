// A probe as files and as text.
#pragma once

#include <string>

#include "analysis/Probe.h"
#include "app/Output.h"
#include "app/display/Display.h"

namespace umbra {

// probe.json, and the plots curves, histogram and cdf each as .png, .svg, .pdf and .csv. The curve
// of technique `selected` is emphasised.
void writeProbe(OutputFolder& folder, Display& display, const Probe& probe, const Json& json,
                std::string_view selected, int bins);

// For people: the region, its statistics and a row for every technique.
std::string probeText(const Probe& probe);
// Every technique's steps, and what goes wrong.
std::string tracesText(const Probe& probe);

}  // namespace umbra
