// Looks up a quantity in a probe or a comparison.
#pragma once

#include <optional>
#include <string_view>

#include "analysis/errors/Metrics.h"
#include "analysis/probe/Probe.h"
#include "filters/core/support/Quantity.h"

namespace umbra {

// The quantity at a probe. Nothing for a technique of which the probe has no result, and for a
// quantity of a frame.
std::optional<double> measured(const Probe& probe, Quantity quantity, std::string_view technique);

// The quantity of a frame; it must be one of these (QuantityInfo::ofFrame).
double measured(const Metrics& metrics, Quantity quantity);

// One sentence, with the region's numbers, that says why the technique's visibility at the probe is
// what it is; "" where the technique explains nothing.
std::string causeOf(const Probe& probe, std::string_view technique);

// "light bleeding", "over-darkening" or "no visible error" (VisibleError.h).
const char* verdictOf(double error);

}  // namespace umbra
