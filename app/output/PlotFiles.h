// Plots as files.
#pragma once

#include <span>

#include "analysis/plots/Plot.h"
#include "app/display/Display.h"
#include "app/output/Output.h"

namespace umbra {

// Each plot as NAME.png, .svg, .pdf and .csv.
void writePlots(OutputFolder& folder, Display& display, std::span<const Plot> plots);

}  // namespace umbra
